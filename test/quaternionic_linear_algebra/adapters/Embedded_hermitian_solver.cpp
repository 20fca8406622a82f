// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Embedded_hermitian_solver.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

#include <new>
#include <numeric>
#include <type_traits>

namespace cgp_test::embedded_hermitian_solver_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using CGP::Solver_status;

template <class Embedding>
class Embedding_of_numbers : public testing::Test {};
using Embeddings =
    testing::Types<CGP::internal::Number_embedding<double>,
                   CGP::internal::Complex_embedding<double>, CGP::internal::Real_embedding<double>>;
TYPED_TEST_SUITE(Embedding_of_numbers, Embeddings);

TYPED_TEST(Embedding_of_numbers, lets_them_stand_for_themselves)
{
  static_assert(TypeParam::width == 1);
  double entry = 0;
  TypeParam::to_entries(3, &entry);
  EXPECT_EQ(entry, 3);
  EXPECT_EQ(TypeParam::from_entries(&entry), 3);
  EXPECT_EQ(TypeParam::block(-2)(0, 0), -2);
}

template <class Embedding>
void expect_left_multiplication()
{
  const Q p{1, 2, 3, 4}, q{-1, 0.5, 2, 1};
  Eigen::Matrix<typename Embedding::Entry, Embedding::width, 1> entries;
  Embedding::to_entries(q, entries.data());
  EXPECT_EQ(Embedding::from_entries(entries.data()), q);
  const auto product = (Embedding::block(p) * entries).eval();
  EXPECT_EQ(Embedding::from_entries(product.data()), p * q);
  EXPECT_EQ(Embedding::block(conjugate(p)), Embedding::block(p).adjoint());
}

TEST(Complex_embedding, lets_quaternions_act_on_pairs_of_complex_numbers)
{
  static_assert(CGP::internal::Complex_embedding<Q>::width == 2);
  expect_left_multiplication<CGP::internal::Complex_embedding<Q>>();
}

TEST(Real_embedding, lets_quaternions_act_on_their_four_components)
{
  static_assert(CGP::internal::Real_embedding<Q>::width == 4);
  expect_left_multiplication<CGP::internal::Real_embedding<Q>>();
}

template <class Scalar_, class Embedding_>
struct Case {
  using Scalar = Scalar_;
  using Embedding = Embedding_;
};

template <class Case>
class Embedded_matrix : public testing::Test {
 protected:
  using Scalar = typename Case::Scalar;
  using Embedding = typename Case::Embedding;
  using Matrix = CGP::internal::Embedded_matrix<Scalar, Embedding>;

  // Entry by entry from the definition: row k of the result is row order[k] of A.
  static void expect_lower_triangle(const Matrix& embedded,
                                    const CGP::Hermitian_sparse_matrix<Scalar>& A,
                                    const CGP::internal::Ordering& order)
  {
    const int w = Embedding::width;
    for (int j = 0; j < A.size(); ++j)
      for (int i = j; i < A.size(); ++i) {
        const auto block = Embedding::block(A.coefficient(order[at(i)], order[at(j)]));
        for (int c = 0; c < w; ++c)
          for (int r = i == j ? c : 0; r < w; ++r)
            EXPECT_EQ(embedded.matrix().coeff(w * i + r, w * j + c), block(r, c));
      }
  }
};

using Cases = testing::Types<Case<double, CGP::internal::Number_embedding<double>>,
                             Case<Q, CGP::internal::Complex_embedding<Q>>,
                             Case<Q, CGP::internal::Real_embedding<Q>>>;
TYPED_TEST_SUITE(Embedded_matrix, Cases);

TYPED_TEST(Embedded_matrix, is_the_lower_triangle_in_factor_order)
{
  const Pattern pattern = random_pattern(15, 1);
  const CGP::internal::Ordering order = random_permutation(15, 2);
  typename TestFixture::Matrix embedded(*pattern, CGP::inverse_permutation(order));
  for (const std::uint64_t seed : {3u, 4u}) {
    const auto A = random_hermitian<typename TestFixture::Scalar>(pattern, seed);
    embedded.set_values(A, {});
    this->expect_lower_triangle(embedded, A, order);
  }
}

TYPED_TEST(Embedded_matrix, adds_the_shift_to_the_diagonal)
{
  const Pattern pattern = random_pattern(15, 5);
  const CGP::internal::Ordering order = random_permutation(15, 6);
  const auto A = random_hermitian<typename TestFixture::Scalar>(pattern, 7);
  const Eigen::VectorXd shift = random_numbers(15, 8);
  typename TestFixture::Matrix embedded(*pattern, CGP::inverse_permutation(order));
  embedded.set_values(A, shift);
  this->expect_lower_triangle(embedded, plus_diagonal(A, shift), order);
}

TYPED_TEST(Embedded_matrix, has_sorted_columns_and_nothing_above_the_diagonal)
{
  const Pattern pattern = random_pattern(15, 9);
  const typename TestFixture::Matrix embedded(*pattern,
                                              CGP::inverse_permutation(random_permutation(15, 10)));
  const auto& matrix = embedded.matrix();
  for (int j = 0; j < matrix.cols(); ++j) {
    EXPECT_EQ(matrix.innerIndexPtr()[matrix.outerIndexPtr()[j]], j);
    EXPECT_TRUE(std::is_sorted(matrix.innerIndexPtr() + matrix.outerIndexPtr()[j],
                               matrix.innerIndexPtr() + matrix.outerIndexPtr()[j + 1]));
  }
}

TEST(Embedded_entries, fit_an_int_or_are_too_many)
{
  EXPECT_EQ(CGP::internal::embedded_entries(5, 7, 1), 5 + 7);
  EXPECT_EQ(CGP::internal::embedded_entries(5, 7, 4), 5 * 10 + 7 * 16);
  EXPECT_EQ(CGP::internal::embedded_entries(1, 134217727, 4), 10 + 2147483632);
  EXPECT_THROW(CGP::internal::embedded_entries(2, 134217727, 4), std::bad_alloc);
}

enum class Step { none, ordering, analysis, factorization, solution };

Step fails_at = Step::none, runs_out_of_memory_at = Step::none;

Solver_status perform(Step step)
{
  if (runs_out_of_memory_at == step) throw std::bad_alloc();
  return fails_at == step ? Solver_status::numerical_issue : Solver_status::success;
}

// Fails on demand.
template <class Entry>
struct Failing_backend {
  using Matrix = Eigen::SparseMatrix<Entry, Eigen::ColMajor, int>;

  static Solver_status find_ordering(const CGP::Sparse_pattern& pattern,
                                     CGP::internal::Ordering& order)
  {
    order.resize(at(pattern.size()));
    std::iota(order.begin(), order.end(), 0);
    return perform(Step::ordering);
  }
  Solver_status analyze(const Matrix&) { return perform(Step::analysis); }
  Solver_status factorize(const Matrix&) { return perform(Step::factorization); }
  Solver_status solve(const CGP::Block<Entry>& b, CGP::Block<Entry>& x) const
  {
    x = b;
    return perform(Step::solution);
  }
  CGP::Solver_statistics statistics() const { return {}; }
};

using Solver = CGP::Embedded_hermitian_solver<Quaternion<double>, Failing_backend>;

// The first status that is not success.
Solver_status run(Solver& solver)
{
  const auto A = random_definite<Quaternion<double>>(random_pattern(6, 1), 2);
  const auto b = random_block<Quaternion<double>>(6, 2, 3);
  CGP::Block<Quaternion<double>> x;
  Solver_status status = solver.analyze(A.pattern());
  if (status == Solver_status::success) status = solver.factorize(A, {});
  if (status == Solver_status::success) status = solver.solve(b, x);
  if (status == Solver_status::success) {
    EXPECT_EQ(real_columns(x), real_columns(b));
  }
  return status;
}

TEST(Embedded_hermitian_solver, passes_on_the_failure_of_any_step_and_recovers)
{
  Solver solver;
  for (const Step step : {Step::ordering, Step::analysis, Step::factorization, Step::solution}) {
    fails_at = step;
    EXPECT_EQ(run(solver), Solver_status::numerical_issue);
    fails_at = Step::none;
    EXPECT_EQ(run(solver), Solver_status::success);
  }
}

TEST(Embedded_hermitian_solver, turns_bad_alloc_into_a_status)
{
  Solver solver;
  for (const Step step : {Step::ordering, Step::analysis, Step::factorization, Step::solution}) {
    runs_out_of_memory_at = step;
    EXPECT_EQ(run(solver), Solver_status::out_of_memory);
    runs_out_of_memory_at = Step::none;
    EXPECT_EQ(run(solver), Solver_status::success);
  }
}

TEST(Embedded_hermitian_solver, forgets_the_old_analysis_when_a_new_one_fails)
{
  Solver solver;
  ASSERT_EQ(run(solver), Solver_status::success);
  fails_at = Step::ordering;
  EXPECT_EQ(solver.analyze(*random_pattern(6, 1)), Solver_status::numerical_issue);
  fails_at = Step::none;
  CGP::Block<Quaternion<double>> x;
  EXPECT_EQ(solver.solve(random_block<Quaternion<double>>(6, 1, 3), x), Solver_status::wrong_state);
}

TEST(Embedded_hermitian_solver, leaves_the_solution_alone_when_it_fails)
{
  Solver solver;
  ASSERT_EQ(run(solver), Solver_status::success);
  fails_at = Step::solution;
  CGP::Block<Quaternion<double>> x = random_block<Quaternion<double>>(2, 2, 4);
  const Eigen::MatrixXd before = real_columns(x);
  EXPECT_EQ(solver.solve(random_block<Quaternion<double>>(6, 1, 3), x),
            Solver_status::numerical_issue);
  EXPECT_EQ(real_columns(x), before);
  fails_at = Step::none;
}

TEST(Embedded_hermitian_solver, cannot_be_copied)
{
  EXPECT_FALSE(std::is_copy_constructible_v<Solver>);
  EXPECT_FALSE(std::is_copy_assignable_v<Solver>);
}

}  // namespace cgp_test::embedded_hermitian_solver_tests
