// Tests flow/Conformal_willmore_flow.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>
#include <Conformal_geometry_processing/surfaces/tori.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "flow_tools.h"
#include "support/figure_eight_torus.h"
#include "support/moebius.h"
#include "support/skewed_tori.h"
#include "support/tori.h"

namespace cgp_test::conformal_willmore_flow_tori_tests {

/// Tori, whose conformal class is a number that can be measured.

/// how far the surface is from the one among its inversions that fits `target` best: the step
/// towards it in units of its size
double distance_from_balance(const CGP::internal::Moebius_balancing& target, const Mesh_view& mesh)
{
  return target.step(mesh).norm() * mesh.positions().colwise().norm().maxCoeff();
}

/// of a surface off the origin
Mesh_view somewhere(const Mesh_view& mesh)
{
  return mapped(mesh, [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(3 * p + Eigen::Vector3d(5, -7, 2));
  });
}

TEST(Conformal_willmore_flow_of_tori, changes_the_conformal_class_in_proportion_to_open_steps)
{
  // The contribution of the mesh is the same for all steps, and cancels in the differences.
  const Mesh_view mesh = twisted_torus(32);
  std::vector<double> changes;
  for (const double limit : {1., 1e-5}) {
    std::vector<std::complex<double>> moduli;
    for (const int steps : {5, 10, 20}) {
      CGP::Flow_options options = plain_steps(2.5 / steps, steps);
      options.surface.max_period_defect = limit;
      CGP::Conformal_willmore_flow flow(mesh, options);
      EXPECT_TRUE(flow.run());
      moduli.push_back(CGP::conformal_modulus(flow.mesh()));
      EXPECT_LT(std::abs(moduli.back() - CGP::conformal_modulus(mesh)), .0164) << steps;
    }
    changes.push_back(std::abs(moduli[0] - moduli[1]));
    if (limit == 1) {
      EXPECT_NEAR(slope({.5, .25}, {changes[0], std::abs(moduli[1] - moduli[2])}), 1, .1);
    }
  }
  EXPECT_LT(changes[1], .2 * changes[0]);
}

// With closed steps the rest is an error of the mesh: it does not depend on the time step.
TEST(Conformal_willmore_flow_of_tori, keeps_the_conformal_class_on_fine_meshes)
{
  std::vector<double> h, drift;
  for (const int n : {24, 32, 48}) {
    const Mesh_view mesh = twisted_torus(n);
    CGP::Flow_options options = plain_steps(.25, 8);
    options.surface.max_period_defect = 1e-5;
    CGP::Conformal_willmore_flow flow(mesh, options);
    EXPECT_TRUE(flow.run());
    h.push_back(1. / n);
    drift.push_back(std::abs(CGP::conformal_modulus(flow.mesh()) - CGP::conformal_modulus(mesh)));
  }
  EXPECT_GT(slope(h, drift), 2);
  EXPECT_LT(drift.back(), .005);
}

TEST(Conformal_willmore_flow_of_tori, comes_to_the_Clifford_torus_on_a_fine_mesh)
{
  CGP::Flow_options options = plain_steps(1, 3);
  options.surface.max_period_defect = 1;  // as in the reference run
  CGP::Conformal_willmore_flow flow(storus(96), options);
  EXPECT_NEAR(flow.energy() / (2 * pi * pi), 1.11449, 1e-5);
  const CGP::Flow_report report = flow.run();
  const double expected[] = {1.00136, 1.00035, 1.00026};
  ASSERT_EQ(report.steps.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(report.steps[i].energy / (2 * pi * pi), expected[i], 1e-5) << i;
  EXPECT_LT(report.conformality.quasi_conformal.mean, 1.0046);
  EXPECT_LT(report.conformality.quasi_conformal.max, 1.02);
}

TEST(Conformal_willmore_flow_of_tori, keeps_the_spin_structure_embedded_or_not)
{
  for (const int arf : {0, 1}) {
    const Mesh_view mesh = turned_torus(64, 32, arf == 1, arf);
    CGP::Flow_options options;
    options.max_steps = 2;
    CGP::Conformal_willmore_flow flow(mesh, options);
    EXPECT_TRUE(flow.run()) << arf;
    EXPECT_EQ(flow.size_of_steps(), 2) << arf;
    EXPECT_LT(flow.energy(), .95 * CGP::willmore_energy(mesh)) << arf;
    EXPECT_EQ(CGP::spin_structure(flow.mesh()), CGP::spin_structure(mesh)) << arf;
    EXPECT_EQ(CGP::spin_structure(flow.mesh()).arf_invariant(), arf);
  }
}

// By reflection symmetry the class is rectangular, so the smoothest surface is a round torus. The
// steps are small where the surface changes most, because their error in the modulus depends on
// their size.
TEST(Conformal_willmore_flow_of_tori, comes_to_the_smoothest_of_the_class_of_a_rectangle)
{
  for (const double b : {1.25, 1.5}) {
    const auto bumpy = [](double R) {
      return tube_torus(R, 60, 40, [](double u, double v) {
        return 1 + .1 * std::cos(6 * pi * u) * std::cos(2 * pi * v) + .07 * std::cos(6 * pi * v);
      });
    };
    const double smoothest = pi * pi * (b + 1 / b);
    const Mesh_view mesh = CGP::torus_of_class(bumpy, b, 1.4, 3);
    CGP::Conformal_willmore_flow slow(mesh, plain_steps(.1, 10));
    EXPECT_GT(slow.energy(), 1.15 * smoothest) << b;
    EXPECT_TRUE(slow.run());
    CGP::Conformal_willmore_flow flow(slow.mesh(), plain_steps(.4, 6));
    EXPECT_TRUE(flow.run());
    EXPECT_NEAR(flow.energy(), smoothest, .01 * smoothest) << b;
    EXPECT_LT(std::abs(CGP::conformal_modulus(flow.mesh()) - CGP::conformal_modulus(mesh)), 1e-3);
    EXPECT_NEAR(CGP::conformal_modulus(flow.mesh()).imag(), b, 1e-3);
  }
}

// One of the Moebius images of a Hopf torus without symmetry. While it loses its folds it drifts
// along inversions. In its class, the energy is above that of the Clifford torus.
TEST(Conformal_willmore_flow_of_tori, converges_on_a_Hopf_torus_if_balanced_and_else_drifts)
{
  const Mesh_view mesh = scaled_to_area(inverted(hopf_torus(24), {.3, .5, 4}), 4 * pi);
  const CGP::internal::Moebius_balancing canonical(CGP::canonical_vertex_areas(
      mesh, CGP::canonical_area_density(
                mesh, CGP::Hodge_decomposition(mesh).harmonic_basis().one_forms)));
  CGP::Flow_options options = plain_steps(1, 20);
  options.surface.max_period_defect = 1e-5;
  CGP::Conformal_willmore_flow adrift(mesh, options);
  options.balance = CGP::Flow_options::Balance::canonical;
  CGP::Conformal_willmore_flow balanced(mesh, options);
  EXPECT_TRUE(adrift.run());
  const CGP::Flow_report report = balanced.run();
  ASSERT_EQ(report.steps.size(), 20U);
  EXPECT_LT(report.steps[18].energy - report.energy, 1e-3 * report.energy);
  EXPECT_LT(report.energy, .81 * report.initial_energy);
  EXPECT_NEAR(adrift.energy(), report.energy, .01 * report.energy);
  EXPECT_LT(std::abs(CGP::conformal_modulus(balanced.mesh()) - CGP::conformal_modulus(mesh)), .002);
  EXPECT_LT(distance_from_balance(canonical, balanced.mesh()), .03);
  EXPECT_GT(distance_from_balance(canonical, adrift.mesh()), .3);
}

TEST(Conformal_willmore_flow_of_tori, keeps_area_and_centroid_however_balanced)
{
  const Mesh_view mesh = somewhere(btorus(12));
  for (const CGP::Flow_options::Balance balance :
       {CGP::Flow_options::Balance::none, CGP::Flow_options::Balance::initial,
        CGP::Flow_options::Balance::canonical})
    for (const CGP::Flow_options::Balancing way :
         {CGP::Flow_options::Balancing::inversion, CGP::Flow_options::Balancing::potential}) {
      CGP::Flow_options options = plain_steps(1, 2);
      options.balance = balance;
      options.balancing = way;
      CGP::Conformal_willmore_flow flow(mesh, options);
      EXPECT_TRUE(flow.run());
      EXPECT_NEAR(area(flow.mesh()), area(mesh), 1e-11 * area(mesh));
      EXPECT_LT((centroid(flow.mesh()) - centroid(mesh)).norm(), 1e-11);
    }
}

/// a torus of revolution about a tube of radius 1, which is `bulge` thicker at two opposite places
Mesh_view tube_around(double radius, double bulge, int n)
{
  const int around = static_cast<int>(std::lround(n * std::sqrt(radius * radius - 1)));
  return mapped(torus(radius, 1, around, n), [&](const Eigen::Vector3d& p) {
    const double angle = std::atan2(p.y(), p.x());
    const Eigen::Vector3d center(radius * std::cos(angle), radius * std::sin(angle), 0);
    return Eigen::Vector3d(center + (1 + bulge * std::cos(2 * angle)) * (p - center));
  });
}

CGP::Flow_report flown(const Mesh_view& mesh, std::optional<double> reduced_volume)
{
  CGP::Flow_options options;
  options.reduced_volume = reduced_volume;
  return CGP::Conformal_willmore_flow(mesh, options).run();
}

// Tori of revolution are images of homogeneous ones, which are stationary in their conformal class,
// so they are, with any volume. From c = 2 on they are saddles [Kuwert and Lorian 2013], and each
// class has surfaces below 8 pi [Kuwert and Schaetzle 2013]: a torus without that symmetry finds
// them.
TEST(Conformal_willmore_flow_of_tori, keeps_tori_of_revolution)
{
  for (const double c : {1.5, 4.}) {
    const Mesh_view mesh = tube_around(c, 0, 12);
    const double expected = pi * pi * c * c / std::sqrt(c * c - 1);
    for (const bool has_volume : {false, true}) {
      std::optional<double> volume;
      if (has_volume) volume = CGP::enclosure(mesh).reduced_volume;
      const CGP::Flow_report report = flown(mesh, volume);
      EXPECT_TRUE(report) << report.message;
      EXPECT_NEAR(report.energy, expected, .05 * expected);
      EXPECT_NEAR(report.energy_of_faces, report.initial_energy_of_faces, 1e-3 * expected);
    }
  }
}

TEST(Conformal_willmore_flow_of_tori, leaves_those_that_are_saddles)
{
  const double stable = flown(tube_around(1.5, .05, 16), {}).energy_of_faces;
  EXPECT_NEAR(stable, pi * pi * 2.25 / std::sqrt(1.25), .05 * stable);
  EXPECT_LT(flown(tube_around(4, .4, 16), {}).energy_of_faces, 8 * pi);
}

}  // namespace cgp_test::conformal_willmore_flow_tori_tests
