// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests curves/polygons.h
#include <Conformal_geometry_processing/curves/polygons.h>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "support/decompositions.h"
#include "support/plane_curves.h"

#include <random>

namespace cgp_test::close_polygon_tests {

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

Curve tangents_of(const Curve& points)
{
  Curve T(2, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    T.col(i) = Eigen::Vector2d(edge(points, i).real(), edge(points, i).imag());
  return T;
}

double angle_of_first_edge(const Curve& points)
{
  return std::arg(edge(points, 0));
}

Curve from_first_point(const Curve& points)
{
  return points.colwise() - points.col(0);
}

Eigen::MatrixXd random_numbers(Eigen::Index rows, Eigen::Index columns)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> numbers(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return numbers(generator); });
}

TEST(Compensated_sum, keeps_what_rounding_would_lose)
{
  CGP::internal::Compensated_sum sum;
  sum.add({1, -1e16});
  for (int i = 0; i < 1000; ++i) sum.add({1e-17, 1});
  sum.add({-1, 1e16});
  EXPECT_NEAR(sum.value().x(), 1e-14, 1e-27);
  EXPECT_EQ(sum.value().y(), 1000);
}

TEST(Integrate_curvature, gives_back_the_edges_of_a_polygon)
{
  for (const Curve& curve : {flower(60), figure_eight(61), rose(72)}) {
    const CGP::internal::Polygon_lengths lengths(curve, true);
    Curve T;
    CGP::integrate_curvature(curvatures_of(curve), lengths, angle_of_first_edge(curve), T);
    EXPECT_LT((T - tangents_of(curve)).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(Integrate_curvature, edges_have_the_lengths_whatever_the_curvature)
{
  const Curve curve = flower(60);
  const CGP::internal::Polygon_lengths lengths(curve, false);
  Curve T;
  CGP::integrate_curvature(random_numbers(60, 1), lengths, 1.2, T);
  ASSERT_EQ(T.cols(), 59);
  for (Eigen::Index i = 0; i < T.cols(); ++i)
    EXPECT_NEAR(T.col(i).norm(), lengths.edges()[i], 1e-15);
}

// the matrix of [CGP 6.4.3]
Eigen::MatrixXd cyclic_laplacian(const Eigen::VectorXd& l)
{
  const Eigen::Index m = l.size();
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(m, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::Index j = (i + 1) % m;
    L(i, i) += 1 / l[i];
    L(j, j) += 1 / l[i];
    L(i, j) -= 1 / l[i];
    L(j, i) -= 1 / l[i];
  }
  return L;
}

// b of a row of tangents, with the sign that fits this matrix
Eigen::VectorXd divergence(const Eigen::RowVectorXd& T, const Eigen::VectorXd& l)
{
  const Eigen::Index m = l.size();
  Eigen::VectorXd b(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::Index before = (i + m - 1) % m;
    b[i] = T[before] / l[before] - T[i] / l[i];
  }
  return b;
}

TEST(Integrate_tangents, solves_the_cyclic_poisson_equation)
{
  const Curve curve = flower(40);
  const CGP::internal::Polygon_lengths lengths(curve, true);
  const Eigen::MatrixXd L = cyclic_laplacian(lengths.edges());
  const Curve T = tangents_of(curve) + 0.1 * random_numbers(2, 40);  // does not close
  Curve f;
  const Eigen::Vector2d gap = CGP::integrate_tangents(T, lengths, f);
  EXPECT_LT((gap - T.rowwise().sum()).norm(), 1e-14);
  for (Eigen::Index row = 0; row < 2; ++row)
    EXPECT_LT((L * f.row(row).transpose() - divergence(T.row(row), lengths.edges())).norm(), 1e-11);
}

TEST(Integrate_tangents, sign_of_b_in_the_thesis_reflects_the_curve)
{
  const Curve curve = from_first_point(flower(40));
  const CGP::internal::Polygon_lengths lengths(curve, true);
  const Curve T = tangents_of(curve);
  Curve f;
  (void)CGP::integrate_tangents(T, lengths, f);
  EXPECT_LT((f - curve).cwiseAbs().maxCoeff(), 1e-14);
  // A vertex is grounded, for L has the constants as its kernel.
  const Eigen::MatrixXd L = cyclic_laplacian(lengths.edges()).bottomRightCorner(39, 39);
  for (Eigen::Index row = 0; row < 2; ++row) {
    const Eigen::VectorXd b_of_thesis = -divergence(T.row(row), lengths.edges()).tail(39);
    const Eigen::VectorXd x = definite_solution(L, b_of_thesis);
    EXPECT_LT((x + curve.row(row).tail(39).transpose()).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(Integrate_tangents, of_an_open_polygon_keeps_every_edge)
{
  const Curve curve = flower(40);
  const CGP::internal::Polygon_lengths lengths(curve, false);
  const Curve T = random_numbers(2, 39);
  Curve f;
  EXPECT_EQ(CGP::integrate_tangents(T, lengths, f), Eigen::Vector2d::Zero());
  EXPECT_LT((f.rightCols(39) - f.leftCols(39) - T).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Integrate_tangents, last_edge_is_no_worse_than_the_others_on_fine_polygons)
{
  const int m = 200000;
  const Curve circle = sampled(m, [](double t) { return std::polar(1., t); });
  const CGP::internal::Polygon_lengths lengths(circle, true);
  Curve f;
  (void)CGP::integrate_tangents(tangents_of(circle), lengths, f);
  // coordinates of up to 2 are rounded to 2^-53, edges are 2 pi / m long
  EXPECT_LT(CGP::length_distortion(f, lengths), 4 * std::ldexp(1., -52) * m / (2 * pi));
}

TEST(Close_polygon, closes_with_the_turning_number_it_is_told)
{
  for (const Curve& curve : {flower(200), figure_eight(200), limacon(200), rose(200)}) {
    const CGP::internal::Polygon_lengths lengths(curve, true);
    Eigen::VectorXd kappa = curvatures_of(curve);
    Eigen::VectorXd v;
    CGP::bending_descent(kappa, curve, lengths, v);
    kappa += .5 * v;
    const int turns = static_cast<int>(std::lround(turns_of(curve)));
    Curve T, points;
    const CGP::internal::Closing_result result =
        CGP::close_polygon(lengths, turns, angle_of_first_edge(curve), curve, kappa, T, points);
    EXPECT_TRUE(result.is_closed);
    EXPECT_GT(result.first_gap, 1e-4);
    EXPECT_LE(result.gap, 1e-13);
    EXPECT_LE(result.iterations, 8);
    EXPECT_LT(T.rowwise().sum().norm(), 2e-13 * lengths.total());
    EXPECT_NEAR(kappa.dot(lengths.duals()), 2 * pi * turns, 1e-11);
  }
}

TEST(Close_polygon, converges_quadratically)
{
  const Curve curve = figure_eight(100);
  const CGP::internal::Polygon_lengths lengths(curve, true);
  const Eigen::VectorXd wave = 1e-2 * random_numbers(100, 1);
  double gaps[2];
  for (int halvings = 0; halvings < 2; ++halvings) {
    Eigen::VectorXd kappa = curvatures_of(curve) + wave / (1 << halvings);
    Curve T, points(2, 100);
    CGP::integrate_curvature(kappa, lengths, 0, T);
    const Eigen::Vector2d gap = CGP::internal::end_to_end(T, points);
    CGP::internal::correct_curvatures(gap, 0, points,
                                      CGP::internal::Closing_functions(curve, lengths.duals()),
                                      curve, lengths, kappa);
    CGP::integrate_curvature(kappa, lengths, 0, T);
    gaps[halvings] = T.rowwise().sum().norm();
    EXPECT_LT(gaps[halvings], 0.05 * gap.norm());
  }
  EXPECT_NEAR(std::log2(gaps[0] / gaps[1]), 2, 0.2);
}

TEST(Close_polygon, leaves_closed_polygons_alone)
{
  const Curve curve = flower(100);
  Eigen::VectorXd kappa = curvatures_of(curve);
  Curve T, points;
  const CGP::internal::Closing_result result = CGP::close_polygon(
      CGP::internal::Polygon_lengths(curve, true), 1, 0.4, curve, kappa, T, points);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(kappa, curvatures_of(curve));
}

TEST(Close_polygon, gives_up_on_what_is_not_finite)
{
  const Curve curve = flower(20);
  Eigen::VectorXd kappa = Eigen::VectorXd::Constant(20, std::nan(""));
  Curve T, points;
  const CGP::internal::Closing_result result = CGP::close_polygon(
      CGP::internal::Polygon_lengths(curve, true), 1, 0, curve, kappa, T, points);
  EXPECT_FALSE(result.is_closed);
  EXPECT_EQ(result.iterations, 0);
}

TEST(Align, undoes_a_motion)
{
  const Curve curve = figure_eight(80);
  const Eigen::VectorXd d = CGP::internal::Polygon_lengths(curve, true).duals();
  Eigen::Matrix2d turn;
  turn << std::cos(2.5), -std::sin(2.5), std::sin(2.5), std::cos(2.5);
  Curve moved = (turn * curve).colwise() + Eigen::Vector2d(3, -8);
  EXPECT_NEAR(CGP::align(curve, d, moved), -2.5, 1e-14);
  EXPECT_LT((moved - curve).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Align, takes_the_best_rotation)
{
  const Curve curve = figure_eight(80);
  Curve other = flower(80);
  const Eigen::VectorXd d = CGP::internal::Polygon_lengths(curve, true).duals();
  (void)CGP::align(curve, d, other);
  EXPECT_LT(((other - curve) * d).norm(), 1e-12);
  const auto misfit = [&](double angle) {
    Eigen::Matrix2d turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Eigen::Vector2d mean = other * d / d.sum();
    const Curve turned = (turn * (other.colwise() - mean)).colwise() + mean;
    return ((turned - curve).colwise().squaredNorm() * d).value();
  };
  for (const double angle : {-2., -.1, .1, 1., 3.}) EXPECT_GT(misfit(angle), misfit(0));
}

}  // namespace cgp_test::close_polygon_tests
