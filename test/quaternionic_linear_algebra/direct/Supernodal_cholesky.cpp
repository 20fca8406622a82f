// Tests include/Quaternionic_linear_algebra/direct/Supernodal_cholesky.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <gtest/gtest.h>

#include <complex>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#include "quaternionic_linear_algebra/every_unit.h"
#include "quaternionic_linear_algebra/solver_laws.h"
#include "support/decompositions.h"

// Compiled alone: it replaces an operator of the whole program.
/// Allocations of more bytes than this fail
std::size_t most_bytes = ~std::size_t(0);

// Not all systems have `std::aligned_alloc()`: before the memory is what to free.
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
  const std::size_t a = static_cast<std::size_t>(alignment);
  void* const all = bytes <= most_bytes ? std::malloc(sizeof(void*) + a + bytes) : nullptr;
  if (all == nullptr) throw std::bad_alloc();
  std::size_t room = a + bytes;
  void* p = static_cast<void**>(all) + 1;
  static_cast<void**>(std::align(a, bytes, p, room))[-1] = all;
  return p;
}
void operator delete(void* p, std::align_val_t) noexcept
{
  if (p != nullptr) std::free(static_cast<void**>(p)[-1]);
}
void operator delete(void* p, std::size_t, std::align_val_t alignment) noexcept
{
  operator delete(p, alignment);
}

namespace cgp_test::supernodal_cholesky_tests {

using Quaternionic = CGP::Supernodal_cholesky<Quaternion<double>>;
using Models = testing::Types<CGP::Supernodal_cholesky<double>,
                              CGP::Supernodal_cholesky<std::complex<double>>, Quaternionic>;
INSTANTIATE_TYPED_TEST_SUITE_P(Supernodal, Hermitian_solver, Models);

static_assert(
    std::is_same_v<CGP::Supernodal_solver_traits::Solver<Quaternion<double>>, Quaternionic>);

template <class Solver>
Eigen::MatrixXd solution(const Solver& solver, const CGP::Block<typename Solver::Scalar>& b)
{
  CGP::Block<typename Solver::Scalar> x;
  EXPECT_EQ(solver.solve(b, x), Solver_status::success);
  return real_columns(x);
}

template <class Solver>
class Supernodal_cholesky : public testing::Test {
 protected:
  Solver solver;
};
TYPED_TEST_SUITE(Supernodal_cholesky, Models);

TYPED_TEST(Supernodal_cholesky, solves_with_one_vertex_without_edges_and_in_many_parts)
{
  on_every_unit([&] {
    using Scalar = typename TypeParam::Scalar;
    for (const Pattern& pattern : {pattern_of_edges(1, {}), pattern_of_edges(9, {}),
                                   pattern_of_edges(8, {{0, 4}, {4, 7}, {7, 0}, {1, 5}, {2, 6}})}) {
      const auto A = random_definite<Scalar>(pattern, 8);
      ASSERT_EQ(this->solver.analyze(*pattern), Solver_status::success);
      ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
      const auto b = random_block<Scalar>(A.size(), 3, 9);
      const Eigen::MatrixXd expected = definite_solution(real_form(A), real_columns(b));
      EXPECT_LE((solution(this->solver, b) - expected).norm(), 1e-12 * expected.norm());
    }
  });
}

TYPED_TEST(Supernodal_cholesky, solves_with_a_dense_matrix_of_300_rows)
{
  using Scalar = typename TypeParam::Scalar;
  const Pattern pattern = full_pattern(300);
  const auto A = random_definite<Scalar>(pattern, 10);
  ASSERT_EQ(this->solver.analyze(*pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
  const auto x = random_block<Scalar>(300, 1, 11);
  const CGP::Block<Scalar> b = A * x.col(0);
  EXPECT_LE((solution(this->solver, b) - real_columns(x)).norm(), 1e-11 * real_columns(x).norm());
}

TYPED_TEST(Supernodal_cholesky, names_the_vertex_of_a_pivot_that_is_not_positive)
{
  const auto A = random_definite<typename TypeParam::Scalar>(random_pattern(50, 12), 13);
  ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
  EXPECT_EQ(this->solver.bad_vertex(), -1);
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(50);
  shift[31] = -2 * A.diagonal(31);
  EXPECT_EQ(this->solver.factorize(A, shift), Solver_status::not_positive_definite);
  EXPECT_EQ(this->solver.bad_vertex(), 31);
  EXPECT_EQ(this->solver.factorize(A, {}), Solver_status::success);
  EXPECT_EQ(this->solver.bad_vertex(), -1);
}

TYPED_TEST(Supernodal_cholesky, that_does_not_fit_tells_how_much_it_needs_and_works_again)
{
  const auto A = random_definite<typename TypeParam::Scalar>(grid_pattern(20, 20), 14);
  ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
  const double needed = this->solver.statistics().bytes;
  EXPECT_GT(needed, 400 * sizeof(typename TypeParam::Scalar));
  most_bytes = 1000;
  EXPECT_EQ(this->solver.factorize(A, {}), Solver_status::out_of_memory);
  EXPECT_EQ(this->solver.statistics().bytes, needed);
  CGP::Block<typename TypeParam::Scalar> x;
  const auto b = random_block<typename TypeParam::Scalar>(400, 1, 15);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  most_bytes = ~std::size_t(0);
  ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
  const Eigen::MatrixXd expected = definite_solution(real_form(A), real_columns(b));
  EXPECT_LE((solution(this->solver, b) - expected).norm(), 1e-12 * expected.norm());
  most_bytes = 1000;
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::out_of_memory);
  most_bytes = ~std::size_t(0);
}

TYPED_TEST(Supernodal_cholesky, that_is_released_can_be_factorized_again)
{
  const auto A = random_definite<typename TypeParam::Scalar>(grid_pattern(9, 9), 19);
  this->solver.release();
  ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
  const auto b = random_block<typename TypeParam::Scalar>(81, 1, 20);
  const Eigen::MatrixXd before = solution(this->solver, b);
  const double needed = this->solver.statistics().bytes;
  this->solver.release();
  CGP::Block<typename TypeParam::Scalar> x;
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.statistics().bytes, needed);
  ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
  EXPECT_EQ(solution(this->solver, b), before);
}

TYPED_TEST(Supernodal_cholesky, counts_the_operations_of_its_scalars)
{
  // On a path every column but the last has one entry below the diagonal.
  const Pattern path = pattern_of_edges(4, {{0, 1}, {1, 2}, {2, 3}});
  ASSERT_EQ(this->solver.analyze(*path, {0, 1, 2, 3}), Solver_status::success);
  constexpr double numbers = sizeof(typename TypeParam::Scalar) / sizeof(double);
  EXPECT_EQ(this->solver.statistics().flops, (3 * 4 + 1) * numbers * numbers);
}

TYPED_TEST(Supernodal_cholesky, overwrites_its_right_hand_side_if_asked_to)
{
  on_every_unit([&] {
    const auto A = random_definite<typename TypeParam::Scalar>(random_pattern(30, 16), 17);
    ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
    ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
    auto b = random_block<typename TypeParam::Scalar>(30, 6, 18);
    const Eigen::MatrixXd expected = solution(this->solver, b);
    ASSERT_EQ(this->solver.solve(b, b), Solver_status::success);
    EXPECT_EQ(real_columns(b), expected);
  });
}

TYPED_TEST(Supernodal_cholesky, gives_a_column_the_same_bits_alone_and_among_others)
{
  on_every_unit([&] {
    using Scalar = typename TypeParam::Scalar;
    for (const Pattern& pattern : {full_pattern(90), grid_pattern(12, 12)}) {
      const auto A = random_definite<Scalar>(pattern, 25);
      ASSERT_EQ(this->solver.analyze(*pattern), Solver_status::success);
      ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
      const auto b = random_block<Scalar>(A.size(), 13, 26);
      std::vector<Eigen::MatrixXd> alone;
      for (Eigen::Index c = 0; c < b.cols(); ++c)
        alone.push_back(solution(this->solver, CGP::Block<Scalar>(b.col(c))));
      for (Eigen::Index columns = 2; columns <= b.cols(); ++columns) {
        const Eigen::MatrixXd x = solution(this->solver, CGP::Block<Scalar>(b.leftCols(columns)));
        for (Eigen::Index c = 0; c < columns; ++c)
          EXPECT_EQ(x.col(c), alone[at(static_cast<int>(c))].col(0)) << c << " of " << columns;
      }
    }
  });
}

TYPED_TEST(Supernodal_cholesky, leaves_the_solution_alone_where_the_right_hand_side_is_not_finite)
{
  using Scalar = typename TypeParam::Scalar;
  const auto A = random_definite<Scalar>(random_pattern(30, 21), 22);
  ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
  for (const int columns : {1, 6}) {
    auto b = random_block<Scalar>(30, columns, 23);
    b(7, columns - 1) =
        CGP::internal::Scalar_traits<Scalar>::from_real(std::numeric_limits<double>::quiet_NaN());
    CGP::Block<Scalar> x = random_block<Scalar>(30, columns, 24);
    const Eigen::MatrixXd before = real_columns(x);
    EXPECT_EQ(this->solver.solve(b, x), Solver_status::numerical_issue);
    EXPECT_EQ(real_columns(x), before);
  }
}

TYPED_TEST(Supernodal_cholesky, keeps_the_vector_unit_that_it_was_analyzed_with)
{
  using Scalar = typename TypeParam::Scalar;
  const auto A = random_definite<Scalar>(grid_pattern(9, 9), 27);
  const auto b = random_block<Scalar>(A.size(), 3, 28);
  on_every_unit([&] {
    ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
    ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
    const Eigen::MatrixXd expected = solution(this->solver, b);
    for (const CGP::internal::Vector_unit other : units_here()) {
      const On_unit setting(other);
      EXPECT_EQ(solution(this->solver, b), expected);
      ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
      EXPECT_EQ(solution(this->solver, b), expected);
    }
  });
}

}  // namespace cgp_test::supernodal_cholesky_tests
