// Tests include/Conformal_geometry_processing/measure/Realised_curvature.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Realised_curvature.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::realised_curvature_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::Realised_curvature;

Curvature_potential waves(const Mesh_view& mesh, double amplitude = 1)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v)
    rho[v] = amplitude * std::sin(3 * mesh.position(v).y() + mesh.position(v).x());
  return Curvature_potential::on_vertices(rho);
}

/// a conformal map of the unit sphere to itself, and its scale of lengths
struct Moebius_copy {
  explicit Moebius_copy(const Mesh_view& sphere) : positions(sphere.positions())
  {
    const Eigen::Vector3d center(0, 0, 2.5);
    const double power = center.squaredNorm() - 1;
    scale.resize(positions.cols());
    for (Eigen::Index v = 0; v < positions.cols(); ++v) {
      const Eigen::Vector3d x = positions.col(v) - center;
      scale[v] = power / x.squaredNorm();
      positions.col(v) = center + scale[v] * x;
    }
    positions.row(1) *= -1;  // inversions reverse orientation
  }

  Points positions;
  Eigen::VectorXd scale;
};

void expect_equal(const Realised_curvature& a, const Realised_curvature& b, double tolerance)
{
  EXPECT_NEAR(a.share, b.share, tolerance);
  EXPECT_NEAR(a.correlation, b.correlation, tolerance);
  EXPECT_NEAR(a.distance, b.distance, tolerance);
  EXPECT_NEAR(a.wrong_sign, b.wrong_sign, tolerance);
  EXPECT_NEAR(a.seen_share, b.seen_share, tolerance);
  EXPECT_NEAR(a.judged_share, b.judged_share, tolerance);
}

TEST(Realised_curvature, of_a_similar_surface_is_zero)
{
  for (const Mesh_view& mesh : {bumpy_sphere(3), scan(600), icosphere(1)}) {
    const auto same = CGP::realised_curvature(mesh, mesh.positions(), waves(mesh));
    ASSERT_TRUE(same);
    EXPECT_EQ(same->share, 0);
    EXPECT_EQ(same->correlation, 0);
    EXPECT_EQ(same->agreement(), 0);
    EXPECT_NEAR(same->distance, 1, 1e-14);
    EXPECT_NEAR(same->judged_share, 1, 1e-14);
    const Points moved =
        ((17 * Random(1).rotation() * mesh.positions()).colwise() + Eigen::Vector3d(30, -40, 500))
            .eval();
    EXPECT_LT(CGP::realised_curvature(mesh, moved, waves(mesh))->share, 1e-10);
  }
}

// H = 1 before and after, so that rho = s - 1.
TEST(Realised_curvature, of_a_moebius_image_of_the_sphere_is_found_with_second_order)
{
  std::vector<double> distances;
  for (int level : {2, 3, 4, 5}) {
    const Mesh_view sphere = icosphere(level);
    const Moebius_copy copy(sphere);
    const auto rho = Curvature_potential::on_vertices((copy.scale.array() - 1).matrix());
    const auto found = CGP::realised_curvature(sphere, copy.positions, rho);
    ASSERT_TRUE(found);
    distances.push_back(found->distance);
    EXPECT_EQ(found->wrong_sign, 0);
    EXPECT_NEAR(found->agreement(), 1, 1.01 * found->distance);
  }
  for (std::size_t i = 1; i < distances.size(); ++i)
    EXPECT_GT(distances[i - 1] / distances[i], 3.5) << distances[i];
  EXPECT_LT(distances.back(), .002);
}

TEST(Realised_curvature, of_a_moebius_image_is_found_on_irregular_meshes)
{
  std::vector<double> distances;
  for (int n : {250, 1000, 4000}) {
    const Points p = scattered_points(n, 1);
    const Mesh_view sphere(p, convex_hull(p));
    const Moebius_copy copy(sphere);
    const auto rho = Curvature_potential::on_vertices((copy.scale.array() - 1).matrix());
    distances.push_back(CGP::realised_curvature(sphere, copy.positions, rho)->distance);
  }
  EXPECT_GT(distances[0] / distances[1], 1.8) << distances[1];
  EXPECT_GT(distances[1] / distances[2], 1.8) << distances[2];
  EXPECT_LT(distances[2], .03);
}

TEST(Realised_curvature, has_the_sign_of_rho)
{
  for (const Mesh_view& sphere : {icosphere(3), icosphere(1)}) {
    const Moebius_copy copy(sphere);
    Eigen::VectorXd rho = copy.scale.array() - 1;
    const auto a =
        CGP::realised_curvature(sphere, copy.positions, Curvature_potential::on_vertices(rho));
    rho = -rho;
    const auto b =
        CGP::realised_curvature(sphere, copy.positions, Curvature_potential::on_vertices(rho));
    EXPECT_NEAR(a->share, b->share, 1e-12);
    EXPECT_NEAR(a->correlation, -b->correlation, 1e-12);
    EXPECT_NEAR(a->agreement(), -b->agreement(), 1e-12);
    EXPECT_NEAR(a->wrong_sign, 1 - b->wrong_sign, 1e-12);
    EXPECT_GT(b->distance, 1.5);
  }
}

TEST(Realised_curvature, does_not_depend_on_units_or_constants)
{
  for (const Mesh_view& mesh : {bumpy_sphere(3), scan(600)}) {
    const Points after = radially_perturbed(mesh, .02).positions();
    const Curvature_potential rho = waves(mesh);
    const auto found = CGP::realised_curvature(mesh, after, rho);
    ASSERT_TRUE(found);
    for (const double unit : {1e-120, .037, 1e120}) {
      const Mesh_view other(unit * mesh.positions(), mesh.corners());
      const auto scaled = CGP::realised_curvature(
          other, 3 * unit * after, Curvature_potential::on_vertices(rho.values / unit));
      ASSERT_TRUE(scaled);
      expect_equal(*scaled, *found, 1e-9);
    }
    const auto raised = CGP::realised_curvature(
        mesh, after, Curvature_potential::on_vertices((rho.values.array() + 5).matrix()));
    expect_equal(*raised, *found, 1e-9);
    const auto with_means = CGP::realised_curvature(
        mesh, after, Curvature_potential::on_vertices((rho.values.array() + 5).matrix()), true);
    EXPECT_LT(with_means->share, .5 * found->share);
  }
}

TEST(Realised_curvature, of_rho_on_faces_is_that_of_its_means)
{
  const Mesh_view sphere = icosphere(4);
  const Moebius_copy copy(sphere);
  Eigen::VectorXd rho(sphere.size_of_faces());
  for (int f = 0; f < rho.size(); ++f) {
    const auto& v = sphere.corners(f);
    rho[f] = (copy.scale[v[0]] + copy.scale[v[1]] + copy.scale[v[2]]) / 3 - 1;
  }
  const auto found =
      CGP::realised_curvature(sphere, copy.positions, Curvature_potential::on_faces(rho));
  EXPECT_LT(found->distance, .01);
}

TEST(Realised_curvature, tells_how_much_of_rho_the_smoothing_leaves)
{
  const Mesh_view sphere = icosphere(4);
  Eigen::VectorXd coarse(sphere.size_of_vertices()), fine(coarse);
  for (int v = 0; v < coarse.size(); ++v) {
    coarse[v] = sphere.position(v).z();
    fine[v] = std::sin(40 * sphere.position(v).z());
  }
  const auto seen = [&](const Eigen::VectorXd& rho) {
    return CGP::realised_curvature(sphere, sphere.positions(),
                                   Curvature_potential::on_vertices(rho))
        ->seen_share;
  };
  const double l = Realised_curvature::smoothing_length;
  EXPECT_NEAR(seen(coarse), 1 / (1 + 2 * l * l), 1e-3);  // the eigenvalue of z is 2
  EXPECT_LT(seen(fine), .2);
}

TEST(Realised_curvature, leaves_out_the_rim)
{
  const Mesh_view sphere = icosphere(4);
  Corners upper;
  for (const auto& v : sphere.corners())
    if (sphere.position(v[0]).z() + sphere.position(v[1]).z() + sphere.position(v[2]).z() > -.6)
      upper.push_back(v);
  const Mesh_view cap(sphere.positions(), upper);  // and vertices without faces
  const Moebius_copy copy(cap);
  const auto rho = Curvature_potential::on_vertices((copy.scale.array() - 1).matrix());
  for (const bool has_means : {false, true}) {
    const auto found = CGP::realised_curvature(cap, copy.positions, rho, has_means);
    ASSERT_TRUE(found);
    EXPECT_LT(found->judged_share, .97);
    EXPECT_GT(found->judged_share, .85);
    EXPECT_LT(found->distance, .02);
    EXPECT_EQ(found->wrong_sign, 0);
  }
}

TEST(Realised_curvature, takes_faces_of_area_zero)
{
  const Mesh_view mesh = spoilt(bumpy_sphere(3));
  const CGP::Delaunay_view view(mesh, 1e-6);
  const auto pattern = CGP::vertex_graph(view);
  const auto judged = [&](const Points& positions) {
    CGP::internal::Solver_ref<double> solver;
    EXPECT_EQ(solver.analyze(*pattern), CGP::Solver_status::success);
    return CGP::internal::realised_curvature(mesh, positions, waves(mesh).values, false, view,
                                             pattern, solver);
  };
  EXPECT_EQ(judged(mesh.positions())->share, 0);
  const auto found = judged(radially_perturbed(mesh, .01).positions());
  for (const double number : {found->share, found->correlation, found->distance, found->wrong_sign,
                              found->seen_share, found->judged_share})
    EXPECT_TRUE(std::isfinite(number));
  EXPECT_GT(found->judged_share, .9);
}

TEST(Realised_curvature, is_not_judged_where_nothing_was_asked_or_positions_are_not_finite)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const auto constant = [&](double c) {
    return Curvature_potential::on_vertices(Eigen::VectorXd::Constant(mesh.size_of_vertices(), c));
  };
  EXPECT_FALSE(CGP::realised_curvature(mesh, mesh.positions(), constant(0)));
  EXPECT_FALSE(CGP::realised_curvature(mesh, mesh.positions(), constant(7)));
  EXPECT_TRUE(CGP::realised_curvature(mesh, mesh.positions(), constant(7), true));
  Points broken = mesh.positions();
  broken(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(CGP::realised_curvature(mesh, broken, waves(mesh)));
  const Mesh_view single(mesh.positions().leftCols(3), {{0, 1, 2}});  // which is all rim
  EXPECT_FALSE(CGP::realised_curvature(single, single.positions(), waves(single)));
}

TEST(Realised_curvature, refuses_other_numbers_of_values)
{
  const Mesh_view mesh = icosphere(1);
  EXPECT_THROW(CGP::realised_curvature(mesh, Points::Zero(3, 2), waves(mesh)),
               CGP::Precondition_error);
  EXPECT_THROW(CGP::realised_curvature(mesh, mesh.positions(),
                                       Curvature_potential::on_vertices(Eigen::VectorXd::Zero(2))),
               CGP::Precondition_error);
}

TEST(Realised_curvature, does_not_make_up_for_a_wrong_shape_by_excess)
{
  Realised_curvature r;
  r.correlation = .4;
  r.share = 5;
  EXPECT_EQ(r.agreement(), .4);
  r.share = .5;
  EXPECT_EQ(r.agreement(), .2);
}

}  // namespace cgp_test::realised_curvature_tests
