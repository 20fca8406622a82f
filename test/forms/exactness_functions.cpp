// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/forms/exactness_functions.h
#include "exactness_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "support/decompositions.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

namespace cgp_test::exactness_functions_tests {

using CGP::Exactness;

constexpr On everywhere[] = {On::vertices, On::faces};

/// expects numbers that agree to three digits
void expect_numbers(const std::vector<double>& found, const std::vector<double>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i] / expected[i], 1, 3e-3) << "number " << i;
}

Eigen::MatrixXd without_means(const Eigen::MatrixXd& z, const Eigen::VectorXd& areas)
{
  return z.rowwise() - (areas.transpose() * z / areas.sum()).eval();
}

TEST(Exactness_functions, of_a_sphere_are_none)
{
  const Exactness_case sphere(icosphere(1));
  for (const On on : everywhere) {
    EXPECT_EQ(sphere.constraints(on).cols(), 0);
    EXPECT_EQ(sphere.constraints(on).rows(), sphere.areas(on).size());
  }
}

// The harmonic part of the new edges, differentiated numerically, for any rho.
TEST(Exactness_functions, are_half_the_derivative_of_the_harmonic_part_of_the_edges)
{
  for (const Mesh_view& mesh : {perturbed(btorus(12), 0.04), smooth_handlebody(2, 1)}) {
    const Exactness_case c(mesh);
    for (const On on : everywhere) {
      const Eigen::VectorXd m = c.areas(on);
      const Eigen::VectorXd rho = random_numbers(static_cast<int>(m.size()), 4);
      const double t = 1e-4;
      const Eigen::MatrixXd change = c.edges_for(on, t * rho) - c.edges_for(on, -t * rho);
      const Eigen::MatrixXd derivative = c.hodge.harmonic_part().coefficients(change) / (2 * t);
      const Eigen::VectorXd predicted = 2 * c.constraints(on).transpose() * m.cwiseProduct(rho);
      const Eigen::VectorXd found = derivative.transpose().reshaped();
      EXPECT_LT((found - predicted).norm(), 1e-6 * predicted.norm());
      EXPECT_GT(predicted.norm(), 1e-2);
    }
  }
}

TEST(Exactness_functions, leave_a_harmonic_part_of_second_order)
{
  const Exactness_case torus(btorus(48));
  const std::vector<double> steps = {.4, .2, .1, .05};
  const auto shares = torus.harmonic_shares(On::vertices, Exactness::adjoint, steps);
  expect_numbers(shares, {2.745e-4, 6.843e-5, 1.708e-5, 4.265e-6});
  EXPECT_NEAR(slope(steps, shares), 2, 0.05);
  const auto on_faces = torus.harmonic_shares(On::faces, Exactness::adjoint, steps);
  EXPECT_NEAR(slope(steps, on_faces), 2, 0.05);
}

TEST(Exactness_functions, of_the_thesis_leave_a_small_part_of_first_order)
{
  const Exactness_case torus(btorus(48));
  const std::vector<double> steps = {.4, .2, .1, .05};
  const auto shares = torus.harmonic_shares(On::vertices, Exactness::thesis, steps);
  expect_numbers(shares, {2.852e-4, 7.741e-5, 2.649e-5, 1.172e-5});
  EXPECT_LT(slope({.1, .05}, {shares[2], shares[3]}), 1.2);
}

TEST(Exactness_functions, are_missed_where_there_are_none)
{
  const Exactness_case torus(btorus(48));
  const std::vector<double> steps = {.4, .2, .1, .05};
  const auto shares = torus.harmonic_shares(On::vertices, std::nullopt, steps);
  expect_numbers(shares, {.1192, .06345, .03283, .01671});
  EXPECT_NEAR(slope({.1, .05}, {shares[2], shares[3]}), 1, 0.05);
}

TEST(Exactness_functions, leave_a_part_of_second_order_on_genus_two)
{
  const Exactness_case body(smooth_handlebody(2, 2));
  const std::vector<double> steps = {.05, .025, .0125};
  for (const On on : everywhere) {
    EXPECT_NEAR(slope(steps, body.harmonic_shares(on, Exactness::adjoint, steps)), 2, 0.05);
    EXPECT_NEAR(slope(steps, body.harmonic_shares(on, Exactness::thesis, steps)), 1, 0.1);
    EXPECT_NEAR(slope(steps, body.harmonic_shares(on, std::nullopt, steps)), 1, 0.05);
  }
}

TEST(Exactness_functions, are_one_less_on_a_torus_of_revolution)
{
  const std::vector<double> expected = {.353, .325, .325, .214, .214, .00055};
  const Exactness_case torus_(scaled_to_area(torus(std::sqrt(2.), 1, 40, 40), 4 * pi));
  const Eigen::VectorXd m = torus_.areas(On::vertices);
  const Eigen::MatrixXd z = without_means(torus_.constraints(On::vertices), m);
  const Eigen::VectorXd values =
      symmetric_eigenvalues(z.transpose() * m.asDiagonal() * z).reverse().cwiseMax(0).cwiseSqrt();
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(values[i], expected[at(i)], 1e-3);
  EXPECT_NEAR(values[5], expected[5], 1e-5);
  const Eigen::MatrixXd of_thesis =
      without_means(torus_.constraints(On::vertices, Exactness::thesis), m);
  EXPECT_EQ(CGP::weighted_orthonormalization(of_thesis, m).cols(), 5);
  const Exactness_case fine(torus(std::sqrt(2.), 1, 56, 56));
  EXPECT_EQ(
      CGP::weighted_orthonormalization(fine.constraints(On::vertices), fine.areas(On::vertices))
          .cols(),
      5);
  const Exactness_case generic(btorus(40));
  EXPECT_EQ(CGP::weighted_orthonormalization(generic.constraints(On::vertices), m).cols(), 6);
}

TEST(Exactness_functions, of_both_versions_agree_in_the_limit)
{
  std::vector<double> sizes, differences;
  for (const int n : {16, 32, 64}) {
    const Exactness_case c(btorus(n));
    const Eigen::VectorXd m = c.areas(On::vertices);
    const Eigen::MatrixXd a = without_means(c.constraints(On::vertices), m);
    const Eigen::MatrixXd b = without_means(c.constraints(On::vertices, Exactness::thesis), m);
    sizes.push_back(1. / n);
    differences.push_back((m.cwiseSqrt().asDiagonal() * (a - b)).norm() / std::sqrt(a.cols()));
  }
  EXPECT_GT(slope(sizes, differences), 1.5);
}

TEST(Exactness_functions, do_not_change_with_the_scale_of_the_mesh)
{
  const Exactness_case c(btorus(12)), large(scaled(btorus(12), 1024));
  for (const On on : everywhere)
    for (const Exactness version : {Exactness::adjoint, Exactness::thesis}) {
      const Eigen::MatrixXd expected = c.constraints(on, version);
      EXPECT_LT((large.constraints(on, version) - expected).norm(), 1e-9 * expected.norm());
    }
}

}  // namespace cgp_test::exactness_functions_tests
