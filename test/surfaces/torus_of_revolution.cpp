// Tests include/Conformal_geometry_processing/surfaces/torus_of_revolution.h
// Tests surfaces/torus_of_class.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/surfaces/round_torus.h>
#include <Conformal_geometry_processing/surfaces/torus_of_class.h>
#include <Conformal_geometry_processing/surfaces/torus_of_revolution.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "support/polyhedra.h"

namespace cgp_test::torus_of_revolution_tests {

namespace CGP = Conformal_geometry_processing;

/// an ellipse with semiaxes 1 and `height`
CGP::internal::Profile ellipse(double height, double distance = 4)
{
  const int n = 8000;
  CGP::internal::Profile profile(2, n);
  for (int i = 0; i < n; ++i)
    profile.col(i) << distance + std::cos(2 * pi * i / n), height * std::sin(2 * pi * i / n);
  return profile;
}

/// pi/2 times the integral of x (curvature + outward normal's x / x)^2 along the ellipse
double willmore_energy_of_revolution(double height, double distance)
{
  const int n = 8000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double c = std::cos(2 * pi * i / n), s = std::sin(2 * pi * i / n), x = distance + c;
    const double speed = std::hypot(s, height * c), curvature = height / std::pow(speed, 3);
    sum += x * std::pow(curvature + height * c / speed / x, 2) * speed * 2 * pi / n;
  }
  return pi / 2 * sum;
}

TEST(Torus_of_revolution, of_a_circle_is_the_round_torus_vertex_by_vertex)
{
  const Mesh_view mesh = CGP::torus_of_revolution(ellipse(1, 2), 20, 12);
  EXPECT_LT((mesh.positions() - CGP::round_torus(2, 1, 20, 12).positions()).norm(), 1e-5);
}

TEST(Conformal_lengths, of_a_circle_add_up_to_those_of_its_torus)
{
  for (const double R : {1.1, 2., 10.})
    EXPECT_NEAR(CGP::conformal_lengths(ellipse(1, R)).sum() * std::sqrt(R * R - 1), 2 * pi, 1e-4);
}

TEST(Torus_of_revolution, has_the_class_and_the_energy_of_its_profile)
{
  for (const double b : {1.2, 2.}) {
    const CGP::internal::Profile profile = CGP::profile_of_class(ellipse(.8), b);
    const double distance = (profile.row(0).maxCoeff() + profile.row(0).minCoeff()) / 2,
                 expected = willmore_energy_of_revolution(.8, distance);
    std::vector<double> h, moduli, energies;
    for (const int n : {24, 48, 96}) {
      const int m = static_cast<int>(b * n);
      const Mesh_view mesh = CGP::torus_of_revolution(profile, m, n);
      h.push_back(1. / n);
      moduli.push_back(std::abs(CGP::conformal_modulus(mesh) - std::complex<double>(0, b)));
      energies.push_back(CGP::willmore_energy(mesh) / expected - 1);
    }
    EXPECT_NEAR(slope(h, moduli), 2, .3) << b;
    EXPECT_LT(moduli.back(), 5e-3) << b;
    EXPECT_NEAR(slope(h, energies), 2, .3) << b;
    EXPECT_LT(std::abs(energies.back()), .01) << b;
  }
}

TEST(Profile_of_class, moves_and_does_not_deform)
{
  for (const double b : {.05, 1., 30.}) {
    const CGP::internal::Profile before = ellipse(.7), after = CGP::profile_of_class(before, b);
    EXPECT_NEAR(CGP::conformal_lengths(after).sum(), 2 * pi / b, 1e-10 / b) << b;
    const Eigen::Matrix2Xd moved = after - before;
    EXPECT_LT((moved.colwise() - moved.col(0)).cwiseAbs().maxCoeff(), 1e-12 * (1 + b)) << b;
    EXPECT_EQ(moved.row(1).cwiseAbs().maxCoeff(), 0);
  }
}

TEST(Torus_of_revolution, refuses_profiles_that_reach_the_axis)
{
  EXPECT_THROW((void)CGP::torus_of_revolution(ellipse(1, 1), 8, 8), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::torus_of_revolution(ellipse(1).leftCols(2), 8, 8),
               CGP::Precondition_error);
  EXPECT_THROW((void)CGP::profile_of_class(ellipse(1, .5), 1), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::profile_of_class(ellipse(1), 0), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::profile_of_class(ellipse(1), INFINITY), CGP::Precondition_error);
}

TEST(Torus_of_class, has_the_modulus_asked_for)
{
  const auto family = [](double R) { return CGP::round_torus(R, 1, 20, 15); };
  for (const double b : {1.1, 1.7}) {
    const std::complex<double> tau = CGP::conformal_modulus(CGP::torus_of_class(family, b, 1.4, 3));
    EXPECT_NEAR(tau.imag(), b, 1e-9);
    EXPECT_NEAR(tau.real(), 0, 1e-9);
  }
}

TEST(Torus_of_class, refuses_families_without_it_and_surfaces_that_are_no_tori)
{
  const auto family = [](double R) { return CGP::round_torus(R, 1, 20, 15); };
  EXPECT_THROW((void)CGP::torus_of_class(family, 5, 1.4, 3), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::torus_of_class([](double) { return tetrahedron(); }, 1, 2, 3),
               CGP::Precondition_error);
}

}  // namespace cgp_test::torus_of_revolution_tests
