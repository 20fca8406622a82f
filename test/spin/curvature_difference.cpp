// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/moebius.h"
#include "support/spheres.h"

#include <algorithm>
#include <cmath>

namespace cgp_test::curvature_difference_tests {

namespace CGP = Conformal_geometry_processing;

/// a surface conformally equivalent to the mesh, of the same area
Mesh_view other(const Mesh_view& mesh)
{
  return scaled_to_area(inverted(mesh, Eigen::Vector3d(0.5, 0.4, 4)), area(mesh));
}

TEST(Curvature_difference, leads_to_the_other_surface_up_to_second_order)
{
  std::vector<double> h, errors;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = bumpy_sphere(level), target = other(mesh);
    const auto rho = CGP::curvature_difference(mesh, target.positions());
    const CGP::Spin_result result = CGP::Spin_transformation(mesh).transform(rho);
    ASSERT_TRUE(result.report);
    h.push_back(std::pow(2., -level));
    errors.push_back(CGP::align(result.positions, target.positions()).rms);
  }
  EXPECT_GE(errors[0] / errors[1], 3.5);
  EXPECT_GE(errors[1] / errors[2], 3.5);
}

TEST(Curvature_difference, leads_to_conformal_surfaces_on_the_way_and_beyond)
{
  const Mesh_view mesh = bumpy_sphere(4), target = other(mesh);
  const auto rho = CGP::curvature_difference(mesh, target.positions());
  CGP::Spin_transformation transformation(mesh);
  for (double t : {0.25, 0.5, 0.75, 1., 1.25}) {
    const CGP::Spin_result result =
        transformation.transform(CGP::Curvature_potential::on_vertices(t * rho.values));
    ASSERT_TRUE(result.report);
    EXPECT_LT(result.report.conformality.quasi_conformal.mean, t <= 1 ? 1.02 : 1.03) << t;
  }
}

TEST(Curvature_difference, is_transferred_as_a_half_density)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  const auto check = [&](const CGP::Curvature_potential& rho, auto areas) {
    const CGP::Curvature_potential there = CGP::transferred(rho, mesh, target);
    const Eigen::VectorXd before = rho.values.cwiseProduct(areas(mesh).cwiseSqrt()),
                          after = there.values.cwiseProduct(areas(target).cwiseSqrt());
    EXPECT_EQ(there.on, rho.on);
    EXPECT_LT((after - before).norm(), 1e-12 * before.norm());
  };
  check(CGP::curvature_difference(mesh, target.positions()),
        [](const Mesh_view& m) { return CGP::voronoi_areas(m); });
  check(CGP::Curvature_potential::on_faces(Eigen::VectorXd::Random(mesh.size_of_faces())),
        [](const Mesh_view& m) { return CGP::face_areas(m); });
}

TEST(Curvature_difference, of_a_surface_to_itself_is_zero_and_changes_sign_on_the_way_back)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  EXPECT_TRUE(CGP::curvature_difference(mesh, mesh.positions()).values.isZero(0));
  const auto there = CGP::curvature_difference(mesh, target.positions());
  const auto back = CGP::curvature_difference(target, mesh.positions());
  // As half-densities, rho times the root of the area.
  const Eigen::VectorXd sum = there.values.cwiseProduct(CGP::voronoi_areas(mesh).cwiseSqrt()) +
                              back.values.cwiseProduct(CGP::voronoi_areas(target).cwiseSqrt());
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Curvature_difference, is_the_same_on_other_surfaces_as_a_half_density)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  const auto there = CGP::curvature_difference(mesh, target.positions());
  const auto back = CGP::curvature_difference(target, mesh.positions());
  EXPECT_LT((CGP::transferred(there, mesh, target).values + back.values).cwiseAbs().maxCoeff(),
            1e-12);
  EXPECT_LT((CGP::transferred(there, mesh, mesh).values - there.values).norm(), 1e-14);
  EXPECT_LT((CGP::transferred(there, mesh, scaled(mesh, 4)).values - there.values / 4).norm(),
            1e-13);
}

TEST(Curvature_difference, is_in_the_units_of_the_mesh)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  const auto rho = CGP::curvature_difference(mesh, target.positions());
  const auto of_half =
      CGP::curvature_difference(scaled(mesh, 0.5), scaled(target, 0.5).positions());
  EXPECT_LT((of_half.values - 2 * rho.values).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Curvature_difference, is_so_for_very_large_and_very_small_units)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  const auto rho = CGP::curvature_difference(mesh, target.positions());
  for (const double unit : {1e-150, 1e-80, 1e80, 1e150}) {
    const Mesh_view there = scaled(mesh, unit);
    const auto found = CGP::curvature_difference(there, scaled(target, unit).positions());
    EXPECT_LT((unit * found.values - rho.values).cwiseAbs().maxCoeff(), 1e-11) << unit;
    const Eigen::VectorXd transferred = CGP::transferred(rho, mesh, there).values;
    EXPECT_LT((unit * transferred - rho.values).cwiseAbs().maxCoeff(), 1e-11) << unit;
  }
}

TEST(Curvature_difference, refuses_other_numbers_of_positions)
{
  EXPECT_THROW((void)CGP::curvature_difference(icosphere(1), Points(3, 2)),
               CGP::Precondition_error);
}

/// the direction in the half plane through the z axis and a point
Eigen::Vector3d tilted(const Eigen::Vector3d& p, double angle)
{
  const Eigen::Vector3d outward = Eigen::Vector3d(p.x(), p.y(), 0).normalized();
  return std::cos(angle) * outward + std::sin(angle) * Eigen::Vector3d::UnitZ();
}

TEST(Turned_binormals, turn_evenly_from_a_disk_to_a_cap_and_beyond)
{
  // The binormals of a disk are horizontal; at a cap of polar angle 1 they point down by the
  // angle 1.
  const Mesh_view flat = disk(20), cap = cap_from_disk(flat, 1.);
  const std::vector<int> rim = CGP::boundary_frames(flat).vertices;
  for (const double t : {-0.5, 0., 0.3, 1., 2.}) {
    const Points B = CGP::turned_binormals(flat, cap, flat, t);
    for (std::size_t k = 0; k < rim.size(); ++k)
      EXPECT_LT((B.col(Eigen::Index(k)) - tilted(flat.position(rim[k]), -t)).norm(), 0.06) << t;
  }
}

TEST(Turned_binormals, are_those_of_the_surfaces_at_the_ends)
{
  const Mesh_view mesh = disk(5), cap = cap_from_disk(mesh, 1.3);
  const Eigen::AngleAxisd tilt(0.4,
                               Eigen::Vector3d::UnitX());  // turns binormals along the boundary
  const Mesh_view tilted_cap =
      mapped(cap, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return tilt * p; });
  const CGP::internal::Boundary_frames from = CGP::boundary_frames(mesh);
  for (const Mesh_view& to : {cap, tilted_cap}) {
    const CGP::internal::Boundary_frames wanted = CGP::boundary_frames(to);
    const Points start = CGP::turned_binormals(mesh, to, mesh, 0),
                 end = CGP::turned_binormals(mesh, to, mesh, 1);
    for (std::size_t k = 0; k < from.vertices.size(); ++k) {
      EXPECT_LT((start.col(Eigen::Index(k)) - from.binormal(k)).norm(), 1e-14);
      EXPECT_LT((end.col(Eigen::Index(k)) - wanted.binormal(k)).norm(), 1e-14);
    }
  }
}

TEST(Turned_binormals, turn_another_surface_by_as_much)
{
  // From a disk to a cap of polar angle 1, from that one as far again: to one of polar angle 2.
  const Mesh_view flat = disk(20), cap = cap_from_disk(flat, 1.);
  const std::vector<int> rim = CGP::boundary_frames(flat).vertices;
  const Points B = CGP::turned_binormals(flat, cap, cap, 1);
  for (std::size_t k = 0; k < rim.size(); ++k)
    EXPECT_LT((B.col(Eigen::Index(k)) - tilted(flat.position(rim[k]), -2)).norm(), 0.1);
}

TEST(Turned_binormals, turn_over_the_normal_by_half_a_turn)
{
  // The disk inside out through a half turn: its binormals point inward, exactly opposite.
  const Mesh_view mesh = unit_square();
  const Mesh_view opposite = mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {-p.x(), -p.y(), p.z()};
  });
  const Points B = CGP::turned_binormals(mesh, opposite, mesh, 0.5);
  EXPECT_LT((B.colwise() - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

/// how far the transformation by rho is from the positions, relative to the diagonal
double distance_by(const CGP::Curvature_potential& rho, const Mesh_view& mesh,
                   const Points& positions)
{
  const CGP::Spin_transformation_options options = CGP::blend_request(mesh, positions, mesh, 1);
  const CGP::Spin_result result = CGP::Spin_transformation(mesh, options).transform(rho);
  EXPECT_TRUE(result.report);
  return CGP::align(result.positions, positions).rms;
}

// Where the plain difference misses by the discretisation error. On nearly round spheres,
// differences of curvature hardly see inversions, of which a tenth of that is left.
TEST(Nearest_curvature_difference, arrives_within_the_tolerance_on_coarse_and_irregular_meshes)
{
  for (const Mesh_view& mesh : {bumpy_sphere(2), perturbed(bumpy_sphere(3), .03)}) {
    const Points other = inverted(mesh, Eigen::Vector3d(.4, .3, 3)).positions();
    const double plain = distance_by(CGP::curvature_difference(mesh, other), mesh, other);
    EXPECT_GT(plain, 2e-3);
    for (const double tolerance : {1e-3, 1e-4}) {
      const auto rho = CGP::nearest_curvature_difference(mesh, other, tolerance);
      EXPECT_LT(distance_by(rho, mesh, other), (std::max)(1.5 * tolerance, .1 * plain));
    }
  }
}

TEST(Nearest_curvature_difference, arrives_with_the_binormals_of_a_boundary)
{
  const Mesh_view mesh = jittered_disk(8, .2);
  const Points cap = cap_from_disk(mesh, 1.2).positions();
  const auto rho = CGP::nearest_curvature_difference(mesh, cap);
  EXPECT_LT(distance_by(rho, mesh, cap),
            .5 * distance_by(CGP::curvature_difference(mesh, cap), mesh, cap));
}

TEST(Nearest_curvature_difference, scales_as_a_curvature)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points other = inverted(mesh, Eigen::Vector3d(.4, .3, 3)).positions();
  const auto rho = CGP::nearest_curvature_difference(mesh, other, 1e-3),
             of_half = CGP::nearest_curvature_difference(scaled(mesh, .5), 3 * other, 1e-3);
  EXPECT_EQ(rho.on, of_half.on);
  EXPECT_LT((of_half.values - 2 * rho.values).norm(), 1e-6 * rho.values.norm());
}

TEST(Nearest_curvature_difference, is_the_plain_one_if_the_search_is_cancelled)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points other = inverted(mesh, Eigen::Vector3d(.4, .3, 3)).positions();
  const auto cancel = [](const CGP::Eigensolver_progress&) { return false; };
  EXPECT_EQ(CGP::nearest_curvature_difference(mesh, other, 1e-4, {}, cancel).values,
            CGP::curvature_difference(mesh, other).values);
}

TEST(Nearest_curvature_difference, refuses_what_does_not_fit)
{
  const Mesh_view mesh = icosphere(1);
  EXPECT_THROW((void)CGP::nearest_curvature_difference(mesh, Points(3, 2)),
               CGP::Precondition_error);
  EXPECT_THROW((void)CGP::nearest_curvature_difference(mesh, mesh.positions(), -1),
               CGP::Precondition_error);
}

}  // namespace cgp_test::curvature_difference_tests
