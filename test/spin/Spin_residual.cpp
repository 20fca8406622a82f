// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <gtest/gtest.h>

#include "support/random.h"

#include <cmath>

namespace cgp_test::spin_residual_tests {

using Conformal_geometry_processing::internal::Scale_residual;

const int vertices = 40;

Eigen::VectorXd irregular_areas()
{
  return 1.5 + random_numbers(vertices, 1).array();
}

/// 1 on the first half of the vertices
Eigen::VectorXd first_half()
{
  return (Eigen::ArrayXd::LinSpaced(vertices, 0, 1) < .5).cast<double>();
}

/// that multiply lengths by e^u
Quaternion_vector<double> spins(const Eigen::VectorXd& u)
{
  Quaternion_vector<double> lambda(u.size());
  for (Eigen::Index v = 0; v < u.size(); ++v) lambda[v] = {0, 0, std::exp(u[v] / 2), 0};
  return lambda;
}

double sum_of_squares(Scale_residual& residual, const Eigen::VectorXd& u)
{
  residual.set_spins(spins(u));
  return residual.values().squaredNorm();
}

TEST(Scale_residual, is_the_weighted_square_of_the_deviation)
{
  const Eigen::VectorXd areas = irregular_areas(), wanted = random_numbers(vertices, 2);
  const Eigen::VectorXd u = random_numbers(vertices, 3),
                        weights = random_numbers(vertices, 4).cwiseAbs();
  Scale_residual residual(areas, wanted, weights);
  residual.set_weight(7);
  Eigen::ArrayXd deviation = u - wanted;
  deviation -= areas.dot(deviation.matrix()) / areas.sum();
  const double expected = 7 * (weights.array() * areas.array() * deviation.square()).sum();
  EXPECT_NEAR(sum_of_squares(residual, u), expected, 1e-12 * expected);
}

TEST(Scale_residual, does_not_see_similarities)
{
  for (const Eigen::VectorXd& weights : {Eigen::VectorXd(), first_half()}) {
    Scale_residual residual(irregular_areas(), Eigen::VectorXd::Zero(vertices), weights);
    EXPECT_NEAR(sum_of_squares(residual, Eigen::VectorXd::Constant(vertices, 3)), 0, 1e-24);
  }
}

// A part whose lengths matter must not grow against the rest, whose lengths do not.
TEST(Scale_residual, sees_parts_that_grow_as_a_whole)
{
  const Eigen::VectorXd areas = irregular_areas(), part = first_half();
  const double share = areas.dot(part) / areas.sum(), growth = .4;
  Scale_residual residual(areas, Eigen::VectorXd::Zero(vertices), part);
  EXPECT_NEAR(sum_of_squares(residual, growth * part),
              areas.dot(part) * std::pow(growth * (1 - share), 2), 1e-12);
}

TEST(Scale_residual, changes_by_its_derivative_and_has_its_transpose)
{
  Scale_residual residual(irregular_areas(), random_numbers(vertices, 2), first_half());
  const Quaternion_vector<double> lambda = spins(random_numbers(vertices, 5));
  const Quaternion_vector<double> d = random_quaternions(vertices, 6);
  const double step = 1e-6;
  residual.set_spins(lambda + step * d);
  const Eigen::VectorXd after = residual.values();
  residual.set_spins(lambda - step * d);
  const Eigen::VectorXd before = residual.values();
  residual.set_spins(lambda);
  const Eigen::VectorXd change = residual.change(d);
  EXPECT_LT((change - (after - before) / (2 * step)).norm(), 1e-7 * change.norm());
  const Eigen::VectorXd y = random_numbers(vertices, 7);
  EXPECT_NEAR(y.dot(change), inner_product(residual.gradient(y), d).w,
              1e-12 * y.norm() * change.norm());
}

}  // namespace cgp_test::spin_residual_tests
