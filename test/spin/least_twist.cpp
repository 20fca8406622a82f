// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Prescribed_boundary.h
#include <Conformal_geometry_processing/spin/Prescribed_boundary.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "support/meshes.h"
#include "support/random.h"

namespace cgp_test::least_twist_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Plane = CGP::internal::Reduced_basis<double>::Plane;
using Eigen::Vector3d;

const Q one{1, 0, 0, 0};

Vector3d direction(double angle)
{
  return {std::cos(angle), std::sin(angle), 0};
}

/// the planes { l : U l = l V } along a loop of n vertices, of functions of an angle in [0, 2 pi)
template <class U, class V>
std::vector<Plane> planes(int n, U u, V v)
{
  std::vector<Plane> p;
  for (int k = 0; k < n; ++k) {
    const double t = 2 * pi * k / n;
    p.push_back(CGP::boundary_plane(u(t), v(t), {0, 0, 1}));
  }
  return p;
}

/// the longest step from one quaternion to the next, around the loop
double longest_step(const std::vector<Q>& q)
{
  double longest = 0;
  for (std::size_t k = 0; k < q.size(); ++k)
    longest = std::max(longest, norm(q[(k + 1) % q.size()] - q[k]));
  return longest;
}

TEST(Least_twist, of_kept_directions_does_not_turn)
{
  for (const Q& q : CGP::least_twist(planes(30, direction, direction), one))
    EXPECT_LT(norm(q - one), 1e-14);
}

TEST(Least_twist, is_the_turn_itself_where_that_turns_all_directions)
{
  const auto tilted = [](double t) {
    return Vector3d(std::cos(t), .6 * std::sin(t), -.8 * std::sin(t));
  };
  // The rotation by arccos .6 about x that takes the one to the other: conjugate(q) U q.
  const Q turn{std::sqrt(.8), std::sqrt(.2), 0, 0};
  for (const Q& q : CGP::least_twist(planes(24, direction, tilted), turn))
    EXPECT_LT(norm(q - turn), 1e-14);
}

TEST(Least_twist, lies_in_the_planes_and_has_unit_length)
{
  Random random(1);
  std::vector<Plane> p;
  for (int k = 0; k < 20; ++k)
    p.push_back(CGP::boundary_plane(random.vector().normalized(), random.vector().normalized(),
                                    random.vector()));
  const std::vector<Q> section = CGP::least_twist(p, one);
  ASSERT_EQ(section.size(), p.size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(norm(section[k]), 1, 1e-14);
    EXPECT_NEAR(std::hypot(dot(section[k], p[k][0]), dot(section[k], p[k][1])), 1, 1e-14);
  }
}

// From the tangents of a circle to targets that go around once more or less, the smallest
// rotations are antiperiodic.
TEST(Least_twist, closes_where_the_smallest_rotations_do_not)
{
  const int n = 200;
  for (const double turns : {0., 2., -1., 3.}) {
    const auto p = planes(n, direction, [&](double t) {
      return Vector3d(.8 * direction(turns * t) + Vector3d(0, 0, .6));
    });
    EXPECT_LT(longest_step(CGP::least_twist(p, one)), 4 * pi * 2 / n) << turns;
  }
}

TEST(Least_twist, spreads_what_is_missing_evenly)
{
  // Cones that turn with t: by symmetry every step is like every other.
  const auto cone = [](double t) { return Vector3d(.6 * direction(t) + Vector3d(0, 0, .8)); };
  const std::vector<Q> q = CGP::least_twist(planes(50, direction, cone), one);
  const double step = norm(q[1] - q[0]);
  for (std::size_t k = 0; k < q.size(); ++k)
    EXPECT_NEAR(norm(q[(k + 1) % q.size()] - q[k]), step, 1e-12);
}

}  // namespace cgp_test::least_twist_tests
