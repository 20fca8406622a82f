// Tests curves/bending_descent.h curves/Closing_functions.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Closing_functions.h>
#include <Conformal_geometry_processing/curves/bending_descent.h>
#include <Conformal_geometry_processing/curves/integrate_curvature.h>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "support/decompositions.h"
#include "support/plane_curves.h"

namespace cgp_test::bending_descent_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Closing_functions, are_orthogonal_and_span_the_coordinates)
{
  const Curve curve = figure_eight(50);
  const Eigen::VectorXd d = CGP::internal::Polygon_lengths(curve, true).duals();
  const CGP::internal::Closing_functions functions(curve, d);
  Eigen::MatrixXd g(3, 50);
  for (Eigen::Index i = 0; i < 50; ++i) g.col(i) = functions.values(curve.col(i));
  Eigen::Matrix3d gram = g * d.asDiagonal() * g.transpose();
  for (Eigen::Index k = 0; k < 3; ++k) EXPECT_NEAR(functions.combination(gram.col(k))[k], 1, 1e-14);
  gram.diagonal().setZero();
  EXPECT_LT(gram.cwiseAbs().maxCoeff(), 1e-13);
  Eigen::MatrixXd both(5, 50);
  both << g, curve;
  EXPECT_EQ(cgp_test::rank(both, 1e-12), 3);
}

TEST(Closing_functions, do_without_a_function_that_is_zero)
{
  Curve line(2, 3);
  line << 0, 1, 2, 0, 0, 0;
  const CGP::internal::Closing_functions functions(line, Eigen::Vector3d::Ones());
  EXPECT_EQ(functions.combination(Eigen::Vector3d(3, 2, 1)), Eigen::Vector3d(1, 1, 0));
}

TEST(Constrained_direction, is_orthogonal_to_one_and_the_coordinates)
{
  for (const Curve& curve : {flower(200), figure_eight(200), limacon(200)}) {
    const CGP::internal::Polygon_lengths lengths(curve, true);
    Eigen::VectorXd v;
    CGP::bending_descent(curvatures_of(curve), curve, lengths, v);
    const Eigen::VectorXd dv = v.cwiseProduct(lengths.duals());
    EXPECT_NEAR(dv.sum(), 0, 1e-12);
    EXPECT_LT((curve * dv).norm(), 1e-12);
  }
}

TEST(Constrained_direction, differs_from_minus_two_kappa_by_the_constraints_alone)
{
  const Curve curve = figure_eight(80);
  const CGP::internal::Polygon_lengths lengths(curve, true);
  const Eigen::VectorXd kappa = curvatures_of(curve);
  Eigen::VectorXd v;
  CGP::bending_descent(kappa, curve, lengths, v);
  Eigen::MatrixXd constraints(80, 3);
  constraints << Eigen::VectorXd::Ones(80), curve.transpose();
  const Eigen::VectorXd rest = v + 2 * kappa;
  const Eigen::Vector3d c = cgp_test::least_squares(constraints, rest);
  EXPECT_LT((constraints * c - rest).norm(), 1e-11 * rest.norm());
  EXPECT_GT(rest.norm(), 0.1);
}

TEST(Constrained_direction, of_an_open_curve_is_minus_two_kappa)
{
  const Curve curve = flower(30);
  Eigen::VectorXd v;
  const Eigen::VectorXd kappa = Eigen::VectorXd::LinSpaced(30, -1, 2);
  CGP::bending_descent(kappa, curve, CGP::internal::Polygon_lengths(curve, false), v);
  EXPECT_EQ(v, Eigen::VectorXd(-2 * kappa));
}

// What can go away is multiplied by 1 - 2 tau in a step: the limit of stability is tau = 1.
TEST(Constrained_direction, on_a_circle_leaves_all_frequencies_above_one)
{
  const int m = 60;
  const Curve circle = sampled(m, [](double t) { return std::polar(1., t); });
  const CGP::internal::Polygon_lengths lengths(circle, true);
  for (const int n : {0, 1, 2, 5, 29}) {
    Eigen::VectorXd wave(m), v;
    for (int i = 0; i < m; ++i) wave[i] = std::cos(2 * pi * n * i / m + 0.3);
    CGP::bending_descent(wave, circle, lengths, v);
    const Eigen::VectorXd expected = n < 2 ? Eigen::VectorXd(0 * wave) : Eigen::VectorXd(-2 * wave);
    EXPECT_LT((v - expected).cwiseAbs().maxCoeff(), 1e-13) << n;
    if (n < 2) continue;
    EXPECT_LT((wave + 0.99 * v).norm(), 0.9801 * wave.norm());
    EXPECT_GT((wave + 1.01 * v).norm(), 1.0199 * wave.norm());
  }
}

double gap_after(const Curve& curve, const Eigen::VectorXd& change)
{
  const CGP::internal::Polygon_lengths lengths(curve, true);
  Curve T;
  CGP::integrate_curvature(curvatures_of(curve) + change, lengths, 0, T);
  return T.rowwise().sum().norm() / lengths.total();
}

TEST(Constrained_direction, opens_the_curve_to_second_order_only)
{
  for (const Curve& curve : {flower(200), figure_eight(200)}) {
    Eigen::VectorXd v;
    CGP::bending_descent(curvatures_of(curve), curve, CGP::internal::Polygon_lengths(curve, true),
                         v);
    const double gaps[] = {gap_after(curve, .1 * v), gap_after(curve, .05 * v),
                           gap_after(curve, .025 * v)};
    EXPECT_NEAR(std::log2(gaps[0] / gaps[1]), 2, 0.05);
    EXPECT_NEAR(std::log2(gaps[1] / gaps[2]), 2, 0.05);
  }
}

TEST(Constrained_direction, with_the_total_turning_alone_the_gap_is_of_first_order)
{
  const auto gap = [](const Curve& curve, double tau) {
    const Eigen::VectorXd kappa = curvatures_of(curve);
    const CGP::internal::Polygon_lengths lengths(curve, true);
    const double mean = kappa.dot(lengths.duals()) / lengths.total();
    return gap_after(curve, -2 * tau * (kappa.array() - mean).matrix());
  };
  EXPECT_NEAR(gap(flower(200), .2), 9.97e-4, 5e-6);
  EXPECT_NEAR(gap(figure_eight(200), .2), .53, 5e-3);
  EXPECT_NEAR(std::log2(gap(figure_eight(200), .001) / gap(figure_eight(200), .0005)), 1, 0.01);
}

}  // namespace cgp_test::bending_descent_tests
