// Tests include/Conformal_geometry_processing/flow/Fairing.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Fairing.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include "flow_tools.h"
#include "support/random.h"

namespace cgp_test::fairing_tests {

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

}  // namespace cgp_test::fairing_tests
