// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/gauge.h>

#include <gtest/gtest.h>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::gauge_tests {

namespace CGP = Conformal_geometry_processing;
using Q = Quaternion<double>;

Eigen::VectorXd some_areas(int n)
{
  return random_numbers(n, 11).array() + 1.5;
}

Q mean(const Quaternion_vector<double>& lambda, const Eigen::VectorXd& areas)
{
  Q sum;
  for (int i = 0; i < lambda.size(); ++i) sum += areas[i] * lambda[i];
  return sum / areas.sum();
}

double mean_square(const Quaternion_vector<double>& lambda, const Eigen::VectorXd& areas)
{
  double sum = 0;
  for (int i = 0; i < lambda.size(); ++i) sum += areas[i] * squared_norm(lambda[i]);
  return sum / areas.sum();
}

TEST(Fix_gauge, turns_a_constant_into_one)
{
  Quaternion_vector<double> lambda = Quaternion_vector<double>::Constant(5, Q{-3, 1, 4, 1});
  CGP::fix_gauge(lambda, some_areas(5));
  for (const Q& q : lambda) EXPECT_LT(norm(q - Q{1, 0, 0, 0}), 1e-15);
}

TEST(Fix_gauge, makes_the_mean_real_and_positive_and_the_mean_square_one)
{
  const Eigen::VectorXd areas = some_areas(20);
  Quaternion_vector<double> lambda = random_quaternions(20, 1);
  CGP::fix_gauge(lambda, areas);
  const Q m = mean(lambda, areas);
  EXPECT_GT(m.w, 0);
  EXPECT_LT(CGP::imaginary_part(m).norm(), 1e-15);
  EXPECT_NEAR(mean_square(lambda, areas), 1, 1e-14);
}

TEST(Fix_gauge, does_not_depend_on_the_unit_of_areas)
{
  const Quaternion_vector<double> before = random_quaternions(20, 1);
  Quaternion_vector<double> wanted = before;
  CGP::fix_gauge(wanted, some_areas(20));
  for (const double unit : {1e-300, 1e-160, 1e160, 1e300}) {
    Quaternion_vector<double> lambda = before;
    CGP::fix_gauge(lambda, unit * some_areas(20));
    for (int i = 0; i < 20; ++i) EXPECT_LT(norm(lambda[i] - wanted[i]), 1e-14) << unit;
  }
}

TEST(Fix_gauge, multiplies_by_one_factor_from_the_right)
{
  const Quaternion_vector<double> before = random_quaternions(20, 1);
  Quaternion_vector<double> after = before;
  CGP::fix_gauge(after, some_areas(20));
  const Q q = CGP::inverse(before[0]) * after[0];
  for (int i = 0; i < 20; ++i) EXPECT_LT(norm(before[i] * q - after[i]), 1e-14);
}

TEST(Fix_gauge, gives_the_same_for_all_eigenvectors_of_a_class)
{
  Quaternion_vector<double> a = random_quaternions(20, 1), b = a;
  for (Q& q : b) q = q * Q{-.2, 3, .1, 5};
  CGP::fix_gauge(a, some_areas(20));
  CGP::fix_gauge(b, some_areas(20));
  EXPECT_LT(greatest_difference(a, b), 1e-14);
}

TEST(Fix_gauge, does_nothing_the_second_time)
{
  Quaternion_vector<double> once = random_quaternions(20, 1);
  CGP::fix_gauge(once, some_areas(20));
  Quaternion_vector<double> twice = once;
  CGP::fix_gauge(twice, some_areas(20));
  EXPECT_LT(greatest_difference(once, twice), 1e-15);
}

TEST(Fix_gauge, makes_the_largest_value_real_where_the_mean_vanishes)
{
  Quaternion_vector<double> lambda(4);
  lambda << Q{0, 3, 0, 0}, Q{0, -3, 0, 0}, Q{0, 0, 0, 1}, Q{0, 0, 0, -1};
  const Eigen::VectorXd areas = Eigen::VectorXd::Ones(4);
  CGP::fix_gauge(lambda, areas);
  EXPECT_GT(lambda[0].w, 0);
  EXPECT_LT(CGP::imaginary_part(lambda[0]).norm(), 1e-15);
  EXPECT_NEAR(mean_square(lambda, areas), 1, 1e-15);
}

TEST(Fix_gauge, works_on_the_normals_of_the_sphere_whose_mean_is_zero)
{
  const Mesh_view mesh = icosphere(2);
  Quaternion_vector<double> lambda = imaginary_columns(mesh.positions());
  CGP::fix_gauge(lambda, Eigen::VectorXd::Ones(162));
  EXPECT_NEAR(mean_square(lambda, Eigen::VectorXd::Ones(162)), 1, 1e-14);
  for (const Q& q : lambda) EXPECT_NEAR(norm(q), 1, 1e-14);
}

}  // namespace cgp_test::gauge_tests
