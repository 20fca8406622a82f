// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Class_keeper.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include "flow_tools.h"
#include "support/random.h"
#include "support/tori.h"

namespace cgp_test::class_keeper_tests {

using CGP::internal::Class_keeper;

/// the share of a bump of degree k of a round sphere that is left
double left_of_bump(int k, double strength)
{
  const Mesh_view sphere = icosphere(4);
  const Mesh_view bumped = mapped(sphere, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d((1 + 1e-3 * legendre(k, p.z())) * p);
  });
  const Points f = CGP::internal::Fairing(sphere, CGP::boundary_vertices(sphere))(bumped, strength),
               round =
                   CGP::internal::Fairing(sphere, CGP::boundary_vertices(sphere))(sphere, strength);
  return (f - round).norm() / (bumped.positions() - sphere.positions()).norm();
}

TEST(Fairing, damps_frequencies_to_second_order)
{
  // On the unit sphere, a function of degree l is multiplied by 1 - (t / (1 + t))^2 with
  // t = s l (l + 1); positions with a radial bump of degree k mix the degrees k - 1 to k + 1. The
  // change of M counts where the sphere itself is moved much.
  const double mean_area = 4 * pi / 2562;
  for (const double strength : {1., 10.})
    for (const int k : {4, 8}) {
      const auto factor = [&](int l) {
        const double t = strength * mean_area * l * (l + 1);
        return 1 - t * t / ((1 + t) * (1 + t));
      };
      EXPECT_LT(left_of_bump(k, strength), 1.02 * factor(k - 1));
      EXPECT_GT(left_of_bump(k, strength), .98 * factor(k + 1));
    }
}

TEST(Fairing, shrinks_a_round_sphere_to_second_order)
{
  const Mesh_view sphere = icosphere(4);
  for (const double strength : {2., 20.}) {
    const Points f =
        CGP::internal::Fairing(sphere, CGP::boundary_vertices(sphere))(sphere, strength);
    const double t = 2 * strength * 4 * pi / 2562;
    EXPECT_NEAR((1 - f.colwise().norm().mean()) / std::pow(t / (1 + t), 2), 1, .05);
  }
}

TEST(Fairing, does_not_depend_on_the_unit_of_length)
{
  const Mesh_view mesh = perturbed(icosphere(3), .02);
  const Points f = CGP::internal::Fairing(mesh, CGP::boundary_vertices(mesh))(mesh, 5),
               g = CGP::internal::Fairing(scaled(mesh, 1e3), CGP::boundary_vertices(mesh))(
                   scaled(mesh, 1e3), 5);
  EXPECT_LT((g - 1e3 * f).norm(), 1e-8);
}

TEST(Fairing, takes_noise_away)
{
  const Mesh_view mesh = radially_perturbed(icosphere(3), .01);
  const Points f = CGP::internal::Fairing(mesh, CGP::boundary_vertices(mesh))(mesh, 5);
  EXPECT_LT(CGP::willmore_energy(Mesh_view(f, mesh.corners())) - 4 * pi,
            .05 * (CGP::willmore_energy(mesh) - 4 * pi));
}

double change(const Mesh_view& mesh, const Points& f)
{
  return CGP::length_cross_ratio_change(mesh, f).max;
}

TEST(Class_keeper, moves_positions_to_the_class_with_area_and_centroid)
{
  for (const Mesh_view& mesh : {bumpy_sphere(3), irregular_torus(2, 1, 24, 12)}) {
    Points f = 3 * perturbed(mesh, .03).positions();
    Class_keeper keeper(mesh);
    EXPECT_TRUE(keeper.snap(f));
    EXPECT_LT(change(mesh, f), 1e-5);
    const Mesh_view snapped(f, mesh.corners());
    EXPECT_NEAR(area(snapped), area(mesh), 1e-10 * area(mesh));
    EXPECT_LT((centroid(snapped) - centroid(mesh)).norm(), 1e-10);
    keeper.polish(f);
    EXPECT_LT(change(mesh, f), 1e-10);
  }
}

TEST(Class_keeper, smooths_within_the_class)
{
  const Mesh_view mesh = radially_perturbed(icosphere(3), .02);
  const double before = CGP::willmore_energy(mesh);
  const auto energy = [&](const Points& f) {
    return CGP::willmore_energy(Mesh_view(f, mesh.corners()));
  };
  const auto f =
      Class_keeper(mesh).smoothed(mesh, [&](const Points& g) { return energy(g) < before; });
  ASSERT_TRUE(f);
  EXPECT_LT(energy(*f), before);
  EXPECT_LT(change(mesh, *f), 1e-5);
}

TEST(Class_keeper, gives_up_where_nothing_is_better)
{
  const Mesh_view mesh = bumpy_sphere(2);
  int trials = 0;
  EXPECT_FALSE(Class_keeper(mesh).smoothed(mesh, [&](const Points&) { return ++trials < 0; }));
  EXPECT_EQ(trials, 3);
}

// Trials that are refused take as long as others: the same one is not made twice in a row.
TEST(Class_keeper, tries_the_weakest_smoothing_once)
{
  const Mesh_view mesh = bumpy_sphere(2);
  Class_keeper keeper(mesh);
  const auto trials = [&] {
    int count = 0;
    EXPECT_FALSE(keeper.smoothed(mesh, [&](const Points&) { return ++count < 0; }));
    return count;
  };
  for (const int count : {3, 3, 1, 1}) EXPECT_EQ(trials(), count);
}

}  // namespace cgp_test::class_keeper_tests
