// Tests algebra/spherical_harmonic.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/algebra/spherical_harmonic.h>

#include <gtest/gtest.h>

#include "support/random.h"

namespace cgp_test::spherical_harmonic_tests {

using Conformal_geometry_processing::spherical_harmonic;
using Complex = std::complex<double>;

TEST(Spherical_harmonic, is_a_polynomial_for_small_degrees)
{
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d p = random.vector().normalized();
    const double x = p.x(), y = p.y(), z = p.z();
    EXPECT_NEAR(std::abs(spherical_harmonic(0, 0, p) - std::sqrt(1 / (4 * pi))), 0, 1e-15);
    EXPECT_NEAR(std::abs(spherical_harmonic(1, 0, p) - std::sqrt(3 / (4 * pi)) * z), 0, 1e-15);
    EXPECT_NEAR(std::abs(spherical_harmonic(1, 1, p) + std::sqrt(3 / (8 * pi)) * Complex(x, y)), 0,
                1e-15);
    EXPECT_NEAR(std::abs(spherical_harmonic(1, -1, p) - std::sqrt(3 / (8 * pi)) * Complex(x, -y)),
                0, 1e-15);
    const Complex expected = std::sqrt(15 / (32 * pi)) * Complex(x, y) * Complex(x, y);
    EXPECT_NEAR(std::abs(spherical_harmonic(2, 2, p) - expected), 0, 1e-15);
    EXPECT_NEAR(
        std::abs(spherical_harmonic(2, -1, p) - std::sqrt(15 / (8 * pi)) * z * Complex(x, -y)), 0,
        1e-15);
  }
}

TEST(Spherical_harmonic, fulfils_the_addition_theorem)
{
  Random random(2);
  const Eigen::Vector3d p = random.vector();
  for (int l : {3, 7, 20}) {
    double sum = 0;
    for (int m = -l; m <= l; ++m) sum += std::norm(spherical_harmonic(l, m, p));
    EXPECT_NEAR(sum, (2 * l + 1) / (4 * pi), 1e-13 * (2 * l + 1)) << l;
  }
}

TEST(Spherical_harmonic, sums_to_the_polynomial_of_legendre_of_two_points)
{
  Random random(3);
  const Eigen::Vector3d p = random.vector(), q = random.vector();
  const double t = p.normalized().dot(q.normalized());
  Complex sum = 0;
  for (int m = -4; m <= 4; ++m)
    sum += spherical_harmonic(4, m, p) * std::conj(spherical_harmonic(4, m, q));
  const double legendre = (35 * t * t * t * t - 30 * t * t + 3) / 8;
  EXPECT_NEAR(std::abs(sum - 9 / (4 * pi) * legendre), 0, 1e-14);
}

TEST(Spherical_harmonic, vanishes_at_the_poles_and_beyond_its_degree)
{
  const Eigen::Vector3d pole(0, 0, -2);
  EXPECT_EQ(spherical_harmonic(3, 2, pole), 0.);
  EXPECT_NEAR(spherical_harmonic(3, 0, pole).real(), -std::sqrt(7 / (4 * pi)), 1e-15);
  EXPECT_EQ(spherical_harmonic(2, 3, pole), 0.);
  EXPECT_EQ(spherical_harmonic(2, -3, pole), 0.);
}

}  // namespace cgp_test::spherical_harmonic_tests
