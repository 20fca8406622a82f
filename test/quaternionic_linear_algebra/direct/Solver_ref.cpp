// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Quaternionic_linear_algebra/direct/Solver_ref.h
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/solver_laws.h"
#include "support/Counted_solver_traits.h"

namespace cgp_test::solver_ref_tests {

using Q = Quaternion<double>;

/// solvers of some traits, behind virtual calls, keep all that the concept promises
template <class SolverTraits, class Scalar_>
struct Wrapped : CGP::internal::Solver_ref<Scalar_> {
  Wrapped()
      : CGP::internal::Solver_ref<Scalar_>(
            CGP::Spin_solvers(SolverTraits()).template solver<Scalar_>())
  {}
};

using Solvers = testing::Types<CGP::internal::Solver_ref<double>, CGP::internal::Solver_ref<Q>,
                               Wrapped<CGP::Eigen_hermitian_solver_traits, double>,
                               Wrapped<CGP::Eigen_hermitian_solver_traits, Q>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Wrapped, Hermitian_solver, Solvers);

TEST(Solver_ref, calls_each_operation_of_the_wrapped_solver_once)
{
  const auto A = random_definite<Q>(random_pattern(20, 1), 2);
  const auto b = random_block<Q>(20, 3, 3);
  CGP::Block<Q> x;
  auto solver = CGP::Spin_solvers(Counted_solver_traits()).solver<Q>();
  Counted_solver_traits::reset();
  ASSERT_EQ(solver.analyze(A.pattern()), CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  ASSERT_EQ(solver.solve(b, x), CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize_preconditioner(A, {}), CGP::Solver_status::success);
  ASSERT_EQ(solver.precondition(b, x), CGP::Solver_status::success);
  const Solver_counts counts = Counted_solver_traits::quaternionic;
  EXPECT_EQ(counts.analyses, 1);
  EXPECT_EQ(counts.factorizations, 2);
  EXPECT_EQ(counts.solves, 6);
}

TEST(Solver_ref, shares_the_analysis_of_its_own_traits)
{
  const Pattern pattern = random_pattern(20, 1);
  for (const CGP::Spin_solvers& traits :
       {CGP::Spin_solvers(), CGP::Spin_solvers(CGP::Eigen_hermitian_solver_traits())}) {
    auto other = traits.solver<Q>();
    ASSERT_EQ(other.analyze(*pattern, random_permutation(20, 9)), CGP::Solver_status::success);
    auto real = other.another<double>();
    auto same = other.another();
    EXPECT_EQ(real.analyze_like(*pattern, other), CGP::Solver_status::success);
    EXPECT_EQ(same.analyze_like(*pattern, real), CGP::Solver_status::success);
    EXPECT_EQ(same.ordering(), real.ordering());
    EXPECT_EQ(real.statistics().factor_entries, other.statistics().factor_entries);
  }
}

TEST(Solver_ref, takes_the_ordering_of_other_traits)
{
  const auto A = random_definite<Q>(random_pattern(20, 1), 2);
  const auto b = random_block<Q>(20, 1, 3);
  const auto eigen = CGP::Spin_solvers(CGP::Eigen_hermitian_solver_traits());
  auto other = eigen.solver<double>();
  ASSERT_EQ(other.analyze(A.pattern(), random_permutation(20, 9)), CGP::Solver_status::success);
  CGP::internal::Solver_ref<Q> solver;
  CGP::Block<Q> x;
  ASSERT_EQ(solver.analyze_like(A.pattern(), other), CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  ASSERT_EQ(solver.solve(b, x), CGP::Solver_status::success);
  EXPECT_LE((real_form(A) * real_columns(x) - real_columns(b)).norm(), 1e-12);
}

TEST(Solver_ref, makes_another_of_the_same_traits)
{
  const CGP::Spin_solvers counted = Counted_solver_traits();
  const Pattern pattern = random_pattern(20, 1);
  Counted_solver_traits::reset();
  const auto first = counted.solver<Q>();
  ASSERT_EQ(first.another().analyze(*pattern), CGP::Solver_status::success);
  ASSERT_EQ(first.another<double>().analyze(*pattern), CGP::Solver_status::success);
  EXPECT_EQ(Counted_solver_traits::quaternionic.analyses, 1);
  EXPECT_EQ(Counted_solver_traits::real.analyses, 1);
  EXPECT_TRUE(first.ordering().empty());
}

}  // namespace cgp_test::solver_ref_tests
