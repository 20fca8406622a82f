// Tests algebra/rotor.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/rotor.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cgp_test::rotor_tests {

namespace CGP = Conformal_geometry_processing;
using Vector3 = Eigen::Vector3d;

Vector3 random_direction(std::mt19937& generator)
{
  std::normal_distribution<double> number;
  return Vector3(number(generator), number(generator), number(generator)).normalized();
}

void expect_turns(const Vector3& u, const Vector3& v, double tolerance)
{
  const CGP::Quaternion<double> q = CGP::rotor(u, v);
  EXPECT_NEAR(CGP::norm(q), 1, 1e-14);
  EXPECT_LE((CGP::spin(q, u) - v).norm(), tolerance);
}

TEST(Rotor, turns_u_into_v)
{
  std::mt19937 generator(3);
  for (int n = 0; n < 100; ++n)
    expect_turns(random_direction(generator), random_direction(generator), 1e-13);
}

TEST(Rotor, is_one_where_nothing_is_to_turn)
{
  const CGP::Quaternion<double> q = CGP::rotor<double>(Vector3::UnitY(), Vector3::UnitY());
  EXPECT_EQ(q, (CGP::Quaternion<double>{1, 0, 0, 0}));
}

TEST(Rotor, takes_the_smaller_angle_about_the_common_normal)
{
  // A quarter turn about z: cos(pi/4) - sin(pi/4) k.
  const CGP::Quaternion<double> q = CGP::rotor<double>(Vector3::UnitX(), Vector3::UnitY());
  EXPECT_NEAR(CGP::norm(q - CGP::Quaternion<double>{std::sqrt(0.5), 0, 0, -std::sqrt(0.5)}), 0,
              1e-15);
}

TEST(Rotor, turns_u_into_minus_u)
{
  std::mt19937 generator(5);
  for (int n = 0; n < 20; ++n) {
    const Vector3 u = random_direction(generator);
    expect_turns(u, -u, 1e-14);
  }
  expect_turns(Vector3::UnitX(), -Vector3::UnitX(), 1e-14);
  expect_turns(Vector3::UnitZ(), -Vector3::UnitZ(), 1e-14);
}

TEST(Rotor, turns_u_into_nearly_minus_u)
{
  std::mt19937 generator(6);
  for (double angle = 1e-1; angle > 1e-16; angle /= 10) {
    const Vector3 u = random_direction(generator), side = u.unitOrthogonal();
    const Vector3 v = (-std::cos(angle) * u + std::sin(angle) * side).normalized();
    expect_turns(u, v, 3e-8);
  }
}

}  // namespace cgp_test::rotor_tests
