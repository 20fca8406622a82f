// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests flow/fair_region.h flow/Fairing_patch.h
#include <Conformal_geometry_processing/flow/fair_region.h>

#include <gtest/gtest.h>

#include <limits>

#include "fairing_tools.h"
#include "support/bounded_meshes.h"
#include "support/fibonacci_sphere.h"
#include "support/random_delaunay.h"
#include "support/spheres.h"
#include "support/tori.h"

namespace cgp_test::fair_region_tests {

using CGP::internal::Fairing_options;
using CGP::internal::Fairing_result;

const Fairing_options by_outline = {false, 100, 1e-7};

/// the cap above z = low is replaced by a flat disk: its stereographic image
Mesh_view with_flat_cap(const Mesh_view& sphere, const std::vector<char>& cap, double low)
{
  return refilled(sphere, cap, [&](const Eigen::Vector3d& p) {
    const double scale = (1 + low) / (1 + p.z());
    return Eigen::Vector3d(scale * p.x(), scale * p.y(), low);
  });
}

struct Errors {
  std::vector<double> h, position, jump;

  void add(const Mesh_view& mesh, double error, const Fairing_result& result)
  {
    h.push_back(mean_edge_length(mesh));
    position.push_back(error);
    jump.push_back(result.report.normal_jump.rms);
  }

  /// \param bound of the last error, by the square of the edge
  void expect_order(double order, double bound) const
  {
    EXPECT_GT(slope(h, position), order);
    EXPECT_LT(position.back(), bound * h.back() * h.back());
    EXPECT_GT(slope(h, jump), .9);
  }
};

double distance_from_unit_sphere(const Points& f)
{
  return (f.colwise().norm().array() - 1).abs().maxCoeff();
}

/// the faces of a torus around the z axis near the point (R, 0, 1), on top of the tube
std::vector<char> top_of_torus(const Mesh_view& mesh, double R)
{
  return region_where(
      mesh, [R](const Eigen::Vector3d& c) { return (c - Eigen::Vector3d(R, 0, 1)).norm() < 1.1; });
}

double distance_from_torus(const Points& f, double R)
{
  double largest = 0;
  for (const Eigen::Vector3d p : f.colwise())
    largest = (std::max)(largest, std::abs(std::hypot(p.head<2>().norm() - R, p.z()) - 1));
  return largest;
}

void expect_same_outside(const Mesh_view& mesh, const std::vector<char>& region, const Points& f)
{
  std::vector<char> is_inside(at(mesh.size_of_vertices()), 1);
  for (int k = 0; k < mesh.size_of_faces(); ++k)
    if (!region[at(k)])
      for (const int v : mesh.corners(k)) is_inside[at(v)] = 0;
  int moved = 0;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    if (f.col(v) != mesh.position(v)) ++moved;
    EXPECT_TRUE(is_inside[at(v)] || f.col(v) == mesh.position(v)) << "vertex " << v;
  }
  EXPECT_GT(moved, 10);
}

TEST(Fair_region, brings_back_the_cap_of_a_sphere)
{
  for (const double low : {.5, 0.}) {  // up to a half sphere
    Errors errors;
    for (const int frequency : {8, 16, 32}) {
      const Mesh_view sphere = geodesic_sphere(frequency);
      const auto cap = region_where(sphere, [&](const auto& c) { return c.z() > low; });
      const Mesh_view flat = with_flat_cap(sphere, cap, low);
      const Fairing_result result = faired(flat, cap, by_outline);
      EXPECT_TRUE(result.report);
      EXPECT_LT(result.report.energy, result.report.initial_energy);
      EXPECT_LT(result.report.normal_jump.rms, .2 * result.report.initial_normal_jump.rms);
      EXPECT_EQ(result.report.conformality.flipped_faces, 0);
      expect_same_outside(flat, cap, result.positions);
      errors.add(sphere, distance_from_unit_sphere(result.positions), result);
    }
    errors.expect_order(1.9, .3);
  }
}

TEST(Fair_region, brings_back_the_cap_of_an_irregular_sphere)
{
  Errors errors;
  for (const double h : {.2, .1, .05, .025}) {
    const Mesh_view sphere = cap_from_disk(random_domain(h, 1), 2.2);
    const auto cap = region_where(sphere, [](const auto& c) { return c.z() > .4; });
    const Fairing_result result = faired(with_flat_cap(sphere, cap, .4), cap, by_outline);
    EXPECT_TRUE(result.report);
    errors.add(sphere, distance_from_unit_sphere(result.positions), result);
  }
  errors.expect_order(1.6, 1);
}

TEST(Fair_region, brings_back_a_part_of_a_clifford_torus_which_is_a_willmore_surface)
{
  const double R = std::sqrt(2.);
  for (const bool is_regular : {true, false}) {
    Errors errors;
    for (const int n : {20, 40, 80, 160}) {
      const int m = 7 * n / 5;
      const Mesh_view mesh = is_regular ? torus(R, 1, m, n) : irregular_torus(R, 1, m, n);
      const auto top = top_of_torus(mesh, R);
      const Mesh_view dented = refilled(mesh, top, [R](const Eigen::Vector3d& p) {
        const double d = (p - Eigen::Vector3d(R, 0, 1)).norm() / 1.1;
        return Eigen::Vector3d(p.x(), p.y(), p.z() - .3 * std::pow(1 - d * d, 2));
      });
      const Fairing_result result = faired(dented, top, by_outline);
      EXPECT_TRUE(result.report);
      errors.add(mesh, distance_from_torus(result.positions, R), result);
    }
    // Where principal curvatures differ, curvatures at the rim of irregular meshes have errors of
    // any frequency, which do not fall; only their means do.
    errors.expect_order(is_regular ? 1.8 : 1, is_regular ? .1 : 1);
  }
}

TEST(Fair_region, changes_other_tori_which_are_no_willmore_surfaces)
{
  const double R = 3;
  std::vector<double> distance;
  for (const int n : {20, 40}) {
    const Mesh_view mesh = torus(R, 1, 2 * n, n);
    const Fairing_result result = faired(mesh, top_of_torus(mesh, R), by_outline);
    EXPECT_LT(result.report.energy, result.report.initial_energy);
    distance.push_back(distance_from_torus(result.positions, R));
  }
  EXPECT_GT(distance.back(), 1e-3);
  EXPECT_NEAR(distance.front() / distance.back(), 1, .5);  // not a discretisation error
}

TEST(Fair_region, makes_a_plane_flat)
{
  const Mesh_view plane = jittered_disk(12, .3);
  const auto middle = region_where(plane, [](const auto& c) { return c.norm() < .7; });
  const Mesh_view bumped = refilled(plane, middle, [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), .2 * std::cos(2 * p.x()));
  });
  const Fairing_result result = faired(bumped, middle, by_outline);
  EXPECT_TRUE(result.report);
  EXPECT_LT(result.positions.row(2).lpNorm<Eigen::Infinity>(), 1e-7);
  EXPECT_LT(result.report.energy, 1e-10);
  EXPECT_EQ(result.report.conformality.flipped_faces, 0);
}

TEST(Fair_region, changes_nothing_the_second_time)
{
  const Mesh_view mesh = torus(3, 1, 40, 20);
  const auto top = top_of_torus(mesh, 3);
  const Fairing_result once = faired(mesh, top, by_outline);
  const Fairing_result twice = faired({once.positions, mesh.corners()}, top, by_outline);
  EXPECT_LT((twice.positions - once.positions).lpNorm<Eigen::Infinity>(), 2e-3);
  EXPECT_LE(twice.report.energy, twice.report.initial_energy);
  EXPECT_NEAR(twice.report.energy, once.report.energy, 1e-4 * once.report.energy);
}

TEST(Fair_region, commutes_with_similarities)
{
  const Mesh_view mesh = irregular_torus(3, 1, 30, 15);
  const auto top = top_of_torus(mesh, 3);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Mesh_view image = mapped(mesh, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(1e5 * (turn * p) + Eigen::Vector3d(3, 4, 5));
  });
  const Points f = faired(mesh, top, by_outline).positions,
               g = faired(image, top, by_outline).positions;
  const Points expected = (1e5 * (turn * f)).colwise() + Eigen::Vector3d(3, 4, 5);
  EXPECT_LT((g - expected).lpNorm<Eigen::Infinity>(), 1e5 * 1e-7);
}

TEST(Fair_region, fairs_rings_and_several_regions_at_once)
{
  const Mesh_view mesh = fibonacci_sphere(2000);
  const auto region = region_where(
      mesh, [](const auto& c) { return std::abs(c.z()) < .3 || c.z() > .8 || c.z() < -.8; });
  const Mesh_view bumped =
      refilled(mesh, region, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(.9 * p); });
  const Fairing_result result = faired(bumped, region, by_outline);
  EXPECT_TRUE(result.report);
  EXPECT_LT(distance_from_unit_sphere(result.positions), 1e-2);
}

TEST(Fair_region, holds_the_first_row_at_the_boundary_of_the_mesh)
{
  const Mesh_view cap = cap_from_disk(random_domain(.05, 1), 1.2);
  const std::vector<char> all(at(cap.size_of_faces()), 1);
  const Mesh_view dented = refilled(cap, all, [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), .5 * p.z() + .2);
  });
  const Fairing_result result = faired(dented, all, by_outline);
  EXPECT_TRUE(result.report);
  EXPECT_LT(distance_from_unit_sphere(result.positions), 5e-3);
}

TEST(Fair_region, stops_when_asked_to_and_after_the_last_step)
{
  const Mesh_view mesh = torus(3, 1, 40, 20);
  const auto top = top_of_torus(mesh, 3);
  for (const bool keeps_class : {true, false}) {
    const Fairing_options options = {keeps_class, 1, 1e-9};
    const Fairing_result one = faired(mesh, top, options);
    EXPECT_FALSE(one.report);
    EXPECT_EQ(one.report.steps, 1);
    EXPECT_EQ(one.report.message, "all steps are done");
    const Fairing_result none =
        CGP::internal::fair_region(mesh, top, options, "test", [] { return false; });
    EXPECT_FALSE(none.report);
    EXPECT_EQ(none.report.message, "cancelled");
  }
}

TEST(Fair_region, is_deterministic)
{
  const Mesh_view mesh = irregular_torus(3, 1, 30, 15);
  for (const bool keeps_class : {true, false})
    EXPECT_EQ(faired(mesh, top_of_torus(mesh, 3), {keeps_class, 5, 1e-5}).positions,
              faired(mesh, top_of_torus(mesh, 3), {keeps_class, 5, 1e-5}).positions);
}

TEST(Fair_region, refuses_points_that_are_not_finite)
{
  Mesh_view mesh = icosphere(2);
  Points f = mesh.positions();
  f(0, 7) = std::numeric_limits<double>::quiet_NaN();
  const auto region = region_where(mesh, [](const auto& c) { return c.z() > 0; });
  mesh.set_positions(f);
  EXPECT_THROW(faired(mesh, region, by_outline), CGP::Precondition_error);
}

}  // namespace cgp_test::fair_region_tests
