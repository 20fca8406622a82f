// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/fair_region.h
#include <Conformal_geometry_processing/flow/fair_region.h>

#include <gtest/gtest.h>

#include "fairing_tools.h"
#include "support/fibonacci_sphere.h"
#include "support/spheres.h"
#include "support/tori.h"

namespace cgp_test::class_fairing_tests {

using CGP::internal::Fairing_options;
using CGP::internal::Fairing_result;

const Fairing_options in_class = {true, 100, 1e-5}, by_outline = {false, 100, 1e-5};

std::vector<char> upper_part(const Mesh_view& mesh)
{
  return region_where(mesh, [](const auto& c) { return c.z() > .4; });
}

/// an ellipsoid with waves on top that vanish to second order at z = .5
Mesh_view waves_on_an_ellipsoid(const Mesh_view& sphere)
{
  return mapped(sphere, [](const Eigen::Vector3d& p) {
    const double t = (std::max)(0., p.z() - .5);
    const Eigen::Vector3d q = (1 + t * t * std::sin(5 * p.x() + 1)) * p;
    return Eigen::Vector3d(1.5 * q.x(), q.y(), q.z());
  });
}

TEST(Class_fairing, lowers_the_energy_and_keeps_length_cross_ratios)
{
  for (const Mesh_view& mesh :
       {waves_on_an_ellipsoid(fibonacci_sphere(800)), waves_on_an_ellipsoid(icosphere(3))}) {
    const auto region = upper_part(mesh);
    const Fairing_result result = faired(mesh, region, in_class);
    EXPECT_TRUE(result.report) << result.report.message;
    EXPECT_LT(result.report.energy, .9 * result.report.initial_energy);
    EXPECT_LT(CGP::length_cross_ratio_change(mesh, result.positions).max, 1e-9);
    EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.05);
    EXPECT_EQ(result.report.conformality.flipped_faces, 0);
    EXPECT_LT(result.report.normal_jump.rms, 1.5 * result.report.initial_normal_jump.rms);
  }
}

// The class and the energy are weighed in a frame of the size of the mesh.
TEST(Class_fairing, does_not_depend_on_the_unit_of_length)
{
  const Mesh_view mesh = waves_on_an_ellipsoid(fibonacci_sphere(800));
  const auto region = upper_part(mesh);
  const Fairing_result expected = faired(mesh, region, in_class);
  for (const double unit : {1e-3, 1e3}) {
    const Fairing_result result =
        faired({unit * mesh.positions(), mesh.corners()}, region, in_class);
    EXPECT_TRUE(result.report) << result.report.message;
    EXPECT_LT((result.positions / unit - expected.positions).lpNorm<Eigen::Infinity>(), 1e-5);
    EXPECT_LT(result.report.conformality.length_cross_ratio.max, 1e-9);
  }
}

TEST(Class_fairing, finds_no_less_energy_than_without_the_class)
{
  const Mesh_view mesh = waves_on_an_ellipsoid(fibonacci_sphere(800));
  const auto region = upper_part(mesh);
  const double of_class = faired(mesh, region, in_class).report.energy,
               of_all = faired(mesh, region, by_outline).report.energy;
  EXPECT_LT(of_all, of_class);
}

TEST(Class_fairing, ends_where_the_energy_is_stationary_in_the_class)
{
  // The same from another surface of the class: the result with the steps of a smaller tolerance.
  const Mesh_view mesh = waves_on_an_ellipsoid(fibonacci_sphere(800));
  const auto region = upper_part(mesh);
  const Fairing_result once = faired(mesh, region, {true, 200, 1e-7});
  const Fairing_result again = faired({once.positions, mesh.corners()}, region, {true, 200, 1e-7});
  EXPECT_LT((again.positions - once.positions).lpNorm<Eigen::Infinity>(), 1e-4);
  EXPECT_NEAR(again.report.energy, once.report.energy, 1e-6);
}

TEST(Class_fairing, leaves_a_clifford_torus_nearly_as_it_is)
{
  const double R = std::sqrt(2.);
  std::vector<double> h, moved;
  for (const int n : {20, 40, 80}) {
    const Mesh_view mesh = torus(R, 1, 7 * n / 5, n);
    const auto top = region_where(mesh, [R](const Eigen::Vector3d& c) {
      return (c - Eigen::Vector3d(R, 0, 1)).norm() < 1.1;
    });
    const Fairing_result result = faired(mesh, top, in_class);
    h.push_back(mean_edge_length(mesh));
    moved.push_back((result.positions - mesh.positions()).lpNorm<Eigen::Infinity>());
  }
  EXPECT_GT(slope(h, moved), 1.5);
}

TEST(Class_fairing, holds_the_rim_bitwise)
{
  const Mesh_view mesh = waves_on_an_ellipsoid(fibonacci_sphere(800));
  const auto region = upper_part(mesh);
  const CGP::internal::Fairing_patch patch(mesh, region, "f");
  std::vector<char> is_free(at(mesh.size_of_vertices()), 0);
  for (int k = 0; k < patch.size(); ++k)
    is_free[at(patch.vertices()[at(patch.free_vertex(k))])] = 1;
  const Points f = faired(mesh, region, in_class).positions;
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    EXPECT_EQ(f.col(v) == mesh.position(v), !is_free[at(v)]);
}

}  // namespace cgp_test::class_fairing_tests
