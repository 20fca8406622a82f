// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Prescribed_boundary.h
#include <Conformal_geometry_processing/spin/Prescribed_boundary.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/mesh_tools.h"
#include "support/random.h"

namespace cgp_test::boundary_planes_tests {

namespace CGP = Conformal_geometry_processing;
using Q = Quaternion<double>;

/// |U l - l V| for l in the plane
double defect(const CGP::internal::Reduced_basis<double>::Plane& plane, double a, double b,
              const Eigen::Vector3d& U, const Eigen::Vector3d& V)
{
  const Q l = a * plane[0] + b * plane[1];
  return norm(CGP::imaginary(U) * l - l * CGP::imaginary(V));
}

/// the spin q with conjugate(q) v q = R v for a turn by `angle` about z
Q turn_about_z(double angle)
{
  return {std::cos(angle / 2), 0, 0, -std::sin(angle / 2)};
}

CGP::internal::Boundary_frame random_frame(Random& random)
{
  return CGP::boundary_frame(random.vector(), random.vector());
}

std::vector<std::vector<int>> one_loop(int n)
{
  return {std::vector<int>(at(n), 0)};
}

TEST(Boundary_plane, holds_the_spins_that_turn_one_direction_into_the_other)
{
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d U = random.vector().normalized(), V = random.vector().normalized();
    const auto plane = CGP::boundary_plane(U, V, random.vector());
    const double a = random.number(), b = random.number();
    EXPECT_LT(defect(plane, a, b, U, V), 1e-14);
    const Q l = a * plane[0] + b * plane[1];
    EXPECT_LT((CGP::spin(l, U) - (a * a + b * b) * V).norm(), 1e-14);
  }
}

TEST(Boundary_plane, is_spanned_by_orthonormal_quaternions)
{
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d U = random.vector().normalized(), V = random.vector().normalized();
    const auto plane = CGP::boundary_plane(U, V, random.vector());
    EXPECT_LT(norm(plane[1] + plane[0] * CGP::imaginary(V)), 1e-15);
    EXPECT_NEAR(norm(plane[0]), 1, 1e-15);
    EXPECT_NEAR(norm(plane[1]), 1, 1e-15);
    EXPECT_NEAR(dot(plane[0], plane[1]), 0, 1e-15);
  }
}

TEST(Boundary_plane, begins_with_the_smallest_turn)
{
  EXPECT_EQ(CGP::boundary_plane({1, 0, 0}, {1, 0, 0}, {0, 0, 1})[0], (Q{1, 0, 0, 0}));
  const Q q = CGP::boundary_plane({1, 0, 0}, {0, 1, 0}, {1, 1, 1})[0];  // a right angle about z
  EXPECT_LT(norm(q - turn_about_z(pi / 2)), 1e-15);
}

TEST(Boundary_plane, of_opposite_directions_is_orthogonal_to_1_and_to_them)
{
  Random random(3);
  for (const double angle : {0., 1e-12, 1e-9, 1e-7, 1e-4}) {
    const Eigen::Vector3d U = random.vector().normalized();
    const Eigen::Vector3d V =
        -(Eigen::AngleAxisd(angle, U.cross(random.vector()).normalized()) * U);
    const auto plane = CGP::boundary_plane(U, V, random.vector());
    EXPECT_LT(defect(plane, .6, -.8, U, V), 1e-7);  // where U + V is rounded away
    EXPECT_LE(std::abs(plane[0].w) + std::abs(plane[1].w), 2 * angle + 1e-15);
    EXPECT_LE(std::abs(dot(plane[0], CGP::imaginary(U))), angle + 1e-15);
    EXPECT_LE(std::abs(dot(plane[1], CGP::imaginary(U))), angle + 1e-15);
  }
}

TEST(Boundary_plane, of_opposite_directions_begins_with_the_half_turn_about_the_axis)
{
  const Q q = CGP::boundary_plane({1, 0, 0}, {-1, 0, 0}, {5, 0, 2})[0];
  EXPECT_LT(norm(q - Q{0, 0, 0, 1}), 1e-15);
}

TEST(Make_continuous, gives_back_the_signs_of_a_smooth_function)
{
  const int n = 40;
  Random random(4);
  std::vector<Q> smooth, values;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n;
    smooth.push_back(Q{1 + .5 * std::cos(t), std::sin(t), .3, 0});
    values.push_back(random.number() < 0 ? -smooth.back() : smooth.back());
  }
  EXPECT_EQ(CGP::make_continuous(one_loop(n), values), std::vector<char>{1});
  EXPECT_EQ(values, smooth);
}

TEST(Make_continuous, tells_how_often_a_loop_has_turned)
{
  for (const int turns : {0, 1, 2, 3}) {
    const int n = 40;
    std::vector<Q> values;
    for (int i = 0; i < n; ++i) values.push_back(turn_about_z(2 * pi * turns * i / n));
    EXPECT_EQ(CGP::make_continuous(one_loop(n), values)[0] != 0, turns % 2 == 0) << turns;
  }
}

TEST(Make_continuous, takes_each_loop_alone)
{
  const std::vector<std::vector<int>> loops = {{5, 6, 7}, {1, 2, 3, 4}};
  std::vector<Q> values = {{-1, 0, 0, 0}, {1, 0, 0, 0},  {-1, 0, 0, 0}, {-2, 1, 0, 0},
                           {-2, 1, 0, 0}, {2, -1, 0, 0}, {2, -1, 0, 0}};
  EXPECT_EQ(CGP::make_continuous(loops, values), (std::vector<char>{1, 1}));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(values[k], (Q{1, 0, 0, 0}));
  for (std::size_t k = 3; k < 7; ++k) EXPECT_EQ(values[k], (Q{2, -1, 0, 0}));
}

TEST(Boundary_spin, turns_one_frame_into_the_other_and_stretches)
{
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const CGP::internal::Boundary_frame source = random_frame(random),
                                        target = random_frame(random);
    const double ratio = 1.1 + random.number();
    const Q l = CGP::boundary_spin(source, target, ratio);
    for (int c = 0; c < 3; ++c)
      EXPECT_LT((CGP::spin(l, source.col(c)) - ratio * target.col(c)).norm(), 1e-14);
  }
}

}  // namespace cgp_test::boundary_planes_tests
