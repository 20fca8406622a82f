// Tests krylov/krylov_schur.h, krylov/Krylov_space.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/krylov_schur.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "quaternionic_linear_algebra/spectral_problem.h"

namespace cgp_test::krylov_schur_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Block = CGP::Block<Q>;

/// K and N of a problem whose N is the masses
CGP::internal::Pencil pencil_of(const Spectral_problem& problem)
{
  CGP::internal::Pencil pencil;
  pencil.K = problem.k();
  pencil.N = problem.n();
  pencil.solve = [&problem](const Block& b) {
    Block x = b;
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (int i = 0; i < problem.size(); ++i) x(i, c) *= 1 / problem.masses()[i];
    return x;
  };
  return pencil;
}

auto noise(int n, std::uint64_t first = 0)
{
  return [n, seed = first](Eigen::Index columns) mutable {
    return random_block<Q>(n, static_cast<int>(columns), ++seed);
  };
}

CGP::internal::Krylov_options wanting(int wanted)
{
  CGP::internal::Krylov_options options;
  options.wanted = wanted;
  return options;
}

/// Values 1 / k of either sign, k = 1, 2, ..., as for an inverse
Eigen::VectorXd reciprocals(int n)
{
  Eigen::VectorXd values(n);
  for (int i = 0; i < n; ++i) values[i] = (i % 2 == 0 ? 1. : -1.) / (i + 1);
  return values;
}

TEST(Krylov_schur, finds_the_eigenpairs_of_largest_modulus_with_their_signs)
{
  const Spectral_problem problem(reciprocals(120));
  const auto r = CGP::krylov_schur(pencil_of(problem), 120, noise(120), wanting(7));
  ASSERT_TRUE(r.converged);
  for (int j = 0; j < 7; ++j) {
    EXPECT_NEAR(r.values[j], problem.value(j), 1e-12);
    EXPECT_LT(problem.sine(r.vectors.col(j), 1, j), 1e-7);
    EXPECT_LT(r.residuals[j], 1e-8);
  }
  const Block gram = CGP::gram_matrix(r.vectors, problem.n()(r.vectors));
  EXPECT_LT((real_form(gram) - Eigen::MatrixXd::Identity(28, 28)).norm(), 1e-11);
}

TEST(Krylov_schur, finds_every_copy_of_an_eigenvalue_even_more_than_a_block_has_columns)
{
  Eigen::VectorXd values = reciprocals(100) / 10;
  values.head(9).setConstant(-2);  // a block for 10 pairs has three columns
  values[9] = 1;
  const Spectral_problem problem(values);
  const auto r = CGP::krylov_schur(pencil_of(problem), 100, noise(100), wanting(10));
  ASSERT_TRUE(r.converged);
  for (int j = 0; j < 9; ++j) EXPECT_NEAR(r.values[j], -2, 1e-12);
  EXPECT_NEAR(r.values[9], 1, 1e-12);
  EXPECT_LT(problem.sine(r.vectors.leftCols(9), 9), 1e-7);
}

/// `copies` of 1 after the larger `first`, then .999, .998, ...
Eigen::VectorXd before_a_dense_rest(const std::vector<double>& first, int copies)
{
  Eigen::VectorXd values(150);
  const int count = static_cast<int>(first.size());
  for (int i = 0; i < 150; ++i)
    values[i] = i < count ? first[at(i)] : (std::min)(1., 1 - .001 * (i - count - copies + 1));
  return values;
}

// Random vectors show a mixture of the copy that is missing and of what comes next.
TEST(Krylov_schur, finds_every_copy_where_the_next_eigenvalues_are_near)
{
  const auto expect_found = [](const Eigen::VectorXd& values, int wanted, auto coefficients,
                               int times) {
    const Spectral_problem problem(values);
    CGP::internal::Pencil pencil = pencil_of(problem);
    pencil.coefficients = coefficients;
    for (std::uint64_t seed : {0, 100, 200}) {
      const auto r = CGP::krylov_schur(pencil, 150, noise(150, seed), wanting(wanted));
      ASSERT_TRUE(r.converged);
      for (int j = 0; j < wanted; ++j) EXPECT_NEAR(r.values[j], values[j / times], 1e-9);
    }
  };
  using CGP::internal::Coefficients;
  for (const int copies : {4, 5})
    expect_found(before_a_dense_rest({10, 9, 8, 7, 6, 5}, copies), 10, Coefficients::quaternions,
                 1);
  expect_found(before_a_dense_rest({}, 12), 14, Coefficients::quaternions, 1);
  expect_found(before_a_dense_rest({}, 3), 14, Coefficients::reals, 4);
}

TEST(Krylov_schur, finds_eigenvalues_much_larger_than_the_others)
{
  for (const double large : {1e4, 1e6}) {
    Eigen::VectorXd values = reciprocals(60);
    values[0] = values[1] = large;
    const Spectral_problem problem(values);
    CGP::internal::Pencil pencil = pencil_of(problem);
    pencil.coefficients = CGP::internal::Coefficients::reals;
    for (std::uint64_t seed = 0; seed < 600; seed += 100) {
      const auto r = CGP::krylov_schur(pencil, 60, noise(60, seed), wanting(10));
      for (int j = 0; j < 8; ++j) EXPECT_NEAR(r.values[j], large, 1e-9 * large);
    }
  }
}

TEST(Krylov_schur, refuses_a_mass_that_is_not_finite)
{
  const Spectral_problem problem(reciprocals(60));
  for (const int broken : {1, 4}) {
    CGP::internal::Pencil pencil = pencil_of(problem);
    pencil.N = [&, N = pencil.N, calls = 0](const Block& x) mutable {
      Block y = N(x);
      if (++calls == broken) y(3, 0).x = std::numeric_limits<double>::quiet_NaN();
      return y;
    };
    EXPECT_THROW((void)CGP::krylov_schur(pencil, 60, noise(60), wanting(4)), CGP::Solver_error);
  }
}

/// noise without the eigenvectors from `missing[k]` on to the fourth one, the k-th time
auto noise_without(const Spectral_problem& problem, std::vector<int> missing)
{
  return [&problem, missing, k = std::size_t(0)](Eigen::Index columns) mutable {
    Block v = random_block<Q>(problem.size(), static_cast<int>(columns), k + 1);
    const int first = k < missing.size() ? missing[k] : 4;
    ++k;
    const Block hidden = problem.vectors().middleCols(first, 4 - first);
    CGP::add_combination(v, hidden, Block(-CGP::gram_matrix(hidden, problem.n()(v))));
    return v;
  };
}

TEST(Krylov_schur, goes_on_as_long_as_random_vectors_find_something_new)
{
  // Four copies of 1, of which the random vectors show one after the other.
  Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(120, 0.7, 0.01);
  values.head(4).setOnes();
  const Spectral_problem problem(values);
  CGP::internal::Krylov_options options = wanting(4);
  options.tolerance = 1e-2;  // reached before rounding errors bring in what is hidden
  const auto r =
      CGP::krylov_schur(pencil_of(problem), 120, noise_without(problem, {1, 2, 3, 4}), options);
  ASSERT_TRUE(r.converged);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(r.values[j], 1, 1e-3);
}

TEST(Krylov_schur, keeps_what_is_known_and_adds_to_it)
{
  const Spectral_problem problem(reciprocals(120));
  const CGP::internal::Pencil pencil = pencil_of(problem);
  const auto few = CGP::krylov_schur(pencil, 120, noise(120), wanting(4));
  const auto more = CGP::krylov_schur(pencil, 120, noise(120), wanting(9), {}, few);
  ASSERT_TRUE(more.converged);
  for (int j = 0; j < 9; ++j) EXPECT_NEAR(more.values[j], problem.value(j), 1e-12);
  const auto again = CGP::krylov_schur(pencil, 120, noise(120), wanting(9), {}, more);
  ASSERT_TRUE(again.converged);
  EXPECT_EQ(again.restarts, 1);  // nothing is left to converge, and another round adds nothing
}

TEST(Krylov_schur, finds_all_eigenpairs_of_a_small_matrix)
{
  const Spectral_problem problem(reciprocals(5));
  const auto r = CGP::krylov_schur(pencil_of(problem), 5, noise(5), wanting(5));
  ASSERT_TRUE(r.converged);
  for (int j = 0; j < 5; ++j) EXPECT_NEAR(r.values[j], problem.value(j), 1e-12);
}

TEST(Krylov_schur, works_over_the_reals_where_eigenvalues_come_four_times)
{
  const Spectral_problem problem(reciprocals(40));
  CGP::internal::Pencil pencil = pencil_of(problem);
  pencil.coefficients = CGP::internal::Coefficients::reals;
  const auto r = CGP::krylov_schur(pencil, 40, noise(40), wanting(8));
  ASSERT_TRUE(r.converged);
  for (int j = 0; j < 8; ++j) EXPECT_NEAR(r.values[j], problem.value(j / 4), 1e-12);
}

TEST(Krylov_schur, tells_when_restarts_were_too_few_and_stops_when_told)
{
  const Spectral_problem problem(Eigen::VectorXd::LinSpaced(120, 1, 1.1));
  CGP::internal::Krylov_options options = wanting(3);
  options.max_restarts = 1;
  const auto r = CGP::krylov_schur(pencil_of(problem), 120, noise(120), options);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.restarts, 1);
  EXPECT_GT(r.residuals.maxCoeff(), options.tolerance);
  const auto stopped =
      CGP::krylov_schur(pencil_of(problem), 120, noise(120), wanting(3),
                        [](const CGP::internal::Krylov_progress& p) { return p.restart < 1; });
  EXPECT_TRUE(stopped.cancelled);
  EXPECT_FALSE(stopped.converged);
}

// Many vectors cost seconds until the first restart.
TEST(Krylov_schur, tells_after_every_block_and_stops_there)
{
  const Spectral_problem problem(reciprocals(120));
  CGP::internal::Pencil pencil = pencil_of(problem);
  const auto K = pencil.K;
  int blocks = 0, told = 0, vectors = 0;
  pencil.K = [&, K](const Block& x) {
    ++blocks;
    return K(x);
  };
  const auto r = CGP::krylov_schur(pencil, 120, noise(120), wanting(20),
                                   [&](const CGP::internal::Krylov_progress& p) {
                                     EXPECT_EQ(p.restart, 0);
                                     EXPECT_EQ(++told, blocks);
                                     EXPECT_GT(p.vectors, vectors);
                                     EXPECT_LE(p.vectors, p.capacity);
                                     vectors = p.vectors;
                                     return told < 3;
                                   });
  EXPECT_TRUE(r.cancelled);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(told, 3);
}

TEST(Krylov_schur, is_deterministic)
{
  const Spectral_problem problem(reciprocals(60));
  const auto once = [&] {
    return CGP::krylov_schur(pencil_of(problem), 60, noise(60), wanting(4));
  };
  const auto a = once(), b = once();
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(real_columns(a.vectors), real_columns(b.vectors));
}

TEST(Krylov_schur, refuses_what_cannot_be_found)
{
  const Spectral_problem problem(reciprocals(5));
  const CGP::internal::Pencil pencil = pencil_of(problem);
  EXPECT_THROW((void)CGP::krylov_schur(pencil, 5, noise(5), wanting(0)), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::krylov_schur(pencil, 5, noise(5), wanting(6)), CGP::Precondition_error);
  CGP::internal::Pencil broken = pencil;
  broken.K = [](const Block& x) {
    return Block::Constant(x.rows(), x.cols(),
                           Q{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0});
  };
  EXPECT_THROW((void)CGP::krylov_schur(broken, 5, noise(5), wanting(1)), CGP::Solver_error);
}

}  // namespace cgp_test::krylov_schur_tests
