// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include "support/bends.h"
#include "support/bounded_meshes.h"
#include "support/figure_eight_torus.h"
#include "support/meshes.h"
#include "support/moebius.h"
#include "support/spheres.h"

#include <cmath>
#include <limits>

namespace cgp_test::nearest_spin_transformation_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Target_mismatch;

Target_mismatch mismatch_of(const Mesh_view& mesh, const Points& target, double normal_weight = 1,
                            double tolerance = 0)
{
  return {mesh, target, CGP::vertex_areas(mesh), normal_weight, tolerance};
}

Points stretched(Points p)
{
  p.row(2) *= 1.3;
  return p;
}

/// two squares of area 4 with the angle between them, 6 points
Points folded(double angle)
{
  const double c = std::cos(angle / 2), s = std::sin(angle / 2);
  Points p(3, 6);
  p.row(0) << -c, 0, c, -c, 0, c;
  p.row(1) << 0, 0, 0, 1, 1, 1;
  p.row(2) << s, 0, s, s, 0, s;
  return 2 * p;
}

Mesh_view::Corners folded_corners()
{
  return {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
}

Points similar(const Points& p, double size)
{
  const Eigen::AngleAxisd turn(.8, Eigen::Vector3d(1, 2, -2).normalized());
  return ((size * turn.toRotationMatrix()) * p).colwise() + size * Eigen::Vector3d(3, -1, 2);
}

TEST(Target_mismatch, of_the_target_is_zero_wherever_and_however_large_it_is)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(2), .05);
  const Points target = stretched(mesh.positions());
  const Target_mismatch mismatch = mismatch_of(mesh, target);
  for (const double size : {1e-60, 1., 1e60}) {
    const Target_mismatch::Value here = mismatch(similar(target, size));
    EXPECT_LT(here.alignment.rms, 1e-12);
    EXPECT_LT(here.normals, 1e-12);
  }
}

TEST(Target_mismatch, of_a_surface_does_not_depend_on_the_size_of_the_target)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(2), .05);
  const Points target = stretched(mesh.positions());
  const Target_mismatch::Value wanted = mismatch_of(mesh, target).source();
  for (const double size : {1e-150, 1e-80, 1e80, 1e150}) {
    const Target_mismatch::Value value = mismatch_of(mesh, size * target).source();
    EXPECT_NEAR(value.alignment.rms, wanted.alignment.rms, 1e-12) << size;
    EXPECT_NEAR(value.normals, wanted.normals, 1e-12) << size;
  }
}

TEST(Target_mismatch, of_the_mesh_is_one_and_the_weight)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points target = stretched(mesh.positions());
  for (const double weight : {0., 1., 3.}) {
    const Target_mismatch mismatch = mismatch_of(mesh, target, weight);
    const Target_mismatch::Value source = mismatch.source();
    EXPECT_NEAR(mismatch.sum(source.alignment.rms, source.normals), 1 + weight, 1e-12);
  }
}

// Waves of a hundredth of the radius, of ever smaller lengths: positions hardly tell them apart.
TEST(Target_mismatch, tells_wrinkles_from_waves_by_the_normals)
{
  const Mesh_view mesh = icosphere(4);
  const Target_mismatch mismatch = mismatch_of(mesh, stretched(mesh.positions()));
  const auto waved = [&](int waves) {
    return mismatch(mapped(mesh, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
                      return (1 + .01 * std::sin(waves * p.z())) * p;
                    }).positions());
  };
  const Target_mismatch::Value few = waved(4), many = waved(16);
  EXPECT_NEAR(many.alignment.rms, few.alignment.rms, .1 * few.alignment.rms);
  EXPECT_GT(many.normals, 1.1 * few.normals);
}

// Either half is turned by half of the angle.
TEST(Target_mismatch, is_the_root_mean_square_chord_of_the_normals)
{
  const Mesh_view mesh(folded(0), folded_corners());
  const Target_mismatch mismatch = mismatch_of(mesh, folded(.6));
  EXPECT_NEAR(mismatch.source().normals, 2 * std::sin(.15), 1e-12);
}

TEST(Target_mismatch, of_flat_surfaces_is_finite)
{
  const Mesh_view mesh(folded(0), folded_corners());
  const Target_mismatch mismatch = mismatch_of(mesh, mesh.positions());
  EXPECT_EQ(mismatch.sum(mismatch.source().alignment.rms, mismatch.source().normals), 0);
}

// A displacement by e of details of 1 % of the diagonal turns normals by 100 e.
TEST(Target_mismatch, is_reached_within_the_tolerance_of_positions_and_normals)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Points target = stretched(mesh.positions());
  const double e = 1e-3;
  const Target_mismatch both = mismatch_of(mesh, target, 1, e),
                        positions_alone = mismatch_of(mesh, target, 0, e);
  EXPECT_TRUE(both.is_reached(.9 * e, 90 * e));
  EXPECT_FALSE(both.is_reached(1.1 * e, 0));
  EXPECT_FALSE(both.is_reached(0, 110 * e));
  EXPECT_TRUE(positions_alone.is_reached(.9 * e, 2));
  EXPECT_FALSE(positions_alone.is_reached(1.1 * e, 0));
}

TEST(Target_mismatch, refuses_weights_and_tolerances_below_zero)
{
  const Mesh_view mesh = icosphere(1);
  for (const double bad : {-1., std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(mismatch_of(mesh, mesh.positions(), bad), CGP::Precondition_error);
    EXPECT_THROW(mismatch_of(mesh, mesh.positions(), 1, bad), CGP::Precondition_error);
  }
}

/// rotations about the x axis by pi z / 6
CGP::Quaternion_vector<double> bending_spins(const Mesh_view& mesh)
{
  CGP::Quaternion_vector<double> mu(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const double angle = pi * mesh.position(v).z() / 6;
    mu[v] = {std::cos(angle / 2), -std::sin(angle / 2), 0, 0};
  }
  return mu;
}

/// the surface with the curvature of the target
CGP::Nearest_spin_options curvature_kept()
{
  CGP::Nearest_spin_options options;
  options.keep_curvature = true;
  return options;
}

double mean_error(const CGP::Spin_result& result)
{
  return result.report.conformality.quasi_conformal.mean;
}

TEST(Nearest_spin_transformation, of_a_bend_is_conformal_where_the_bend_itself_never_becomes_so)
{
  const std::vector<double> direct = {1.1949, 1.1870, 1.1848}, nearest = {1.02661, 1.01320, 1.0066};
  for (std::size_t i = 0; i < 3; ++i) {
    const Mesh_view mesh = beam(4 << i);
    CGP::Nearest_spin_transformation near(mesh, bending_spins(mesh), "test", curvature_kept());
    const CGP::Nearest_spin_result result = near.transform();
    ASSERT_TRUE(result.report);
    EXPECT_NEAR(mean_error(result) - 1, nearest[i] - 1, 0.02 * (nearest[i] - 1));
    const CGP::Spin_result all = near.blend(result, 1);
    EXPECT_NEAR(mean_error(all) - 1, direct[i] - 1, 0.02 * (direct[i] - 1));
    EXPECT_EQ(near.sign_conflicts(), 0);
  }
}

TEST(Nearest_spin_transformation, refuses_to_be_called_by_its_own_visitor)
{
  const Mesh_view mesh = beam(4);
  CGP::Nearest_spin_transformation nearest(mesh, bending_spins(mesh)),
      undisturbed(mesh, bending_spins(mesh));
  const CGP::Nearest_spin_result expected = undisturbed.transform();
  int refused = 0;
  const CGP::Nearest_spin_result result = nearest.transform([&](const CGP::Eigensolver_progress&) {
    EXPECT_THROW((void)nearest.transform(), CGP::Precondition_error);
    EXPECT_THROW((void)nearest.blend(expected, .5), CGP::Precondition_error);
    EXPECT_THROW(nearest.scale_lengths(Eigen::VectorXd::Ones(mesh.size_of_vertices())),
                 CGP::Precondition_error);
    return ++refused > 0;
  });
  EXPECT_GT(refused, 0);
  EXPECT_EQ(result.positions, expected.positions);
}

TEST(Nearest_spin_transformation, blends_from_the_conformal_surface_to_the_target)
{
  const Mesh_view mesh = beam(8);
  CGP::Nearest_spin_transformation near(mesh, bending_spins(mesh), "test", curvature_kept());
  const CGP::Nearest_spin_result result = near.transform();
  const std::vector<double> expected = {1.049, 1.093, 1.139};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(mean_error(near.blend(result, 0.25 * (i + 1))), expected[at(i)], 2e-3);
  EXPECT_NEAR(mean_error(near.blend(result, 0)), mean_error(result), 1e-12);
}

TEST(Nearest_spin_transformation, bends_by_more_than_half_a_turn_without_flipping_a_face)
{
  const Mesh_view mesh = beam(4), target = bent_beam(mesh, 324 * pi / 180);
  CGP::Nearest_spin_transformation near(mesh, target.positions(), "test", curvature_kept());
  const CGP::Nearest_spin_result result = near.transform();
  ASSERT_TRUE(result.report);
  EXPECT_EQ(result.report.conformality.flipped_faces, 0);
  EXPECT_LT(mean_error(result), 1.2);
}

TEST(Nearest_spin_transformation, of_a_conformal_map_is_that_map)
{
  std::vector<double> h, distances;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = bumpy_sphere(level);
    const Mesh_view target = inverted(mesh, Eigen::Vector3d(0.4, 0.3, 2.5));
    CGP::Nearest_spin_transformation near(mesh, target.positions(), "test", curvature_kept());
    const CGP::Nearest_spin_result result = near.transform();
    ASSERT_TRUE(result.report);
    h.push_back(std::pow(2., -level));
    distances.push_back(result.distance);
  }
  EXPECT_LT(distances[1], 0.003);
  EXPECT_LT(distances[2], 0.0008);
  EXPECT_GT(slope(h, distances), 1.7);
}

TEST(Nearest_spin_transformation, does_not_depend_on_the_unit)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points target = inverted(mesh, Eigen::Vector3d(0.4, 0.3, 2.5)).positions();
  const double distance =
      CGP::Nearest_spin_transformation(mesh, target, "test", curvature_kept()).transform().distance;
  for (const double unit : {1e-150, 1e-80, 1e80, 1e150}) {
    CGP::Nearest_spin_transformation near(scaled(mesh, unit), Points(unit * target), "test",
                                          curvature_kept());
    const CGP::Nearest_spin_result result = near.transform();
    EXPECT_TRUE(result.report) << unit;
    EXPECT_NEAR(result.distance, distance, 1e-6) << unit;
  }
}

TEST(Nearest_spin_transformation, of_a_stretch_is_the_surface_itself)
{
  const Mesh_view mesh = beam(4);
  const Mesh_view target = mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {p.x(), p.y(), 1.5 * p.z()};
  });
  CGP::Nearest_spin_transformation near(mesh, target.positions(), "test", curvature_kept());
  EXPECT_LT(near.potential().values.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(mean_error(near.transform()), 1 + 1e-10);
}

TEST(Nearest_spin_transformation, of_a_disk_has_the_tangents_of_the_target)
{
  const std::vector<double> expected = {1.02051, 1.01026};
  for (std::size_t i = 0; i < 2; ++i) {
    const Mesh_view mesh = disk(i == 0 ? 16 : 32);
    CGP::Nearest_spin_transformation near(mesh, cap_from_disk(mesh, 1.2).positions(), "test",
                                          curvature_kept());
    const CGP::Nearest_spin_result result = near.transform();
    ASSERT_TRUE(result.report);
    EXPECT_NEAR(mean_error(result) - 1, expected[i] - 1, 0.02 * (expected[i] - 1));
    EXPECT_LT(result.distance, 3e-4);
  }
}

TEST(Nearest_spin_transformation, scales_lengths_where_it_is_told_to)
{
  const Mesh_view mesh = icosphere(3);
  CGP::Nearest_spin_transformation near(mesh, mesh.positions());
  EXPECT_LT(near.potential().values.cwiseAbs().maxCoeff(), 1e-12);
  Eigen::VectorXd factor(mesh.size_of_vertices());
  for (int v = 0; v < factor.size(); ++v) factor[v] = std::exp(0.3 * mesh.position(v).z());
  near.scale_lengths(factor);
  for (int v = 0; v < factor.size(); ++v)
    EXPECT_NEAR(squared_norm(near.target_spins()[v]), factor[v], 1e-12);
  EXPECT_TRUE(near.transform().report);
}

TEST(Nearest_spin_transformation, refuses_targets_that_do_not_fit)
{
  const Mesh_view mesh = icosphere(1);
  using Near = CGP::Nearest_spin_transformation;
  EXPECT_THROW(Near(mesh, Points(3, 5)), CGP::Precondition_error);
  Points target = mesh.positions();
  target(1, 3) = std::nan("");
  EXPECT_THROW(Near(mesh, target), CGP::Precondition_error);
  target.setZero();
  EXPECT_THROW(Near(mesh, target), CGP::Precondition_error);
  EXPECT_THROW(Near(mesh, CGP::Quaternion_vector<double>(3)), CGP::Precondition_error);
  Near near(mesh, mesh.positions());
  EXPECT_THROW(near.scale_lengths(Eigen::VectorXd::Ones(4)), CGP::Precondition_error);
  EXPECT_THROW(near.scale_lengths(Eigen::VectorXd::Zero(mesh.size_of_vertices())),
               CGP::Precondition_error);
}

TEST(Nearest_spin_transformation, keeps_the_spin_structure_and_refuses_targets_of_another)
{
  using Near = CGP::Nearest_spin_transformation;
  const Mesh_view circle = turned_torus(32, 16, false, 0), odd = turned_torus(48, 24, true, 1);
  EXPECT_THROW(Near(circle, turned_torus(32, 16, true, 0).positions()), CGP::Precondition_error);
  for (const Mesh_view& mesh : {circle, odd}) {
    Points target = mesh.positions();
    target.row(2) += .1 * target.row(0).cwiseProduct(target.row(1));
    const CGP::Nearest_spin_result result = Near(mesh, target).transform();
    EXPECT_TRUE(result.report.converged);
    EXPECT_NO_THROW(CGP::require_same_spin_structure(mesh, result.positions, "result"));
  }
}

}  // namespace cgp_test::nearest_spin_transformation_tests
