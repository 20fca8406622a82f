// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Quaternionic_linear_algebra/krylov/Eigensolver_ref.h
#include <Quaternionic_linear_algebra/krylov/Eigensolver_ref.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test::eigensolver_ref_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Eigensolver_ref;
using Q = CGP::Quaternion<double>;

/// tells what it was asked
struct Echo {
  int wanted_more = 0;

  template <class Masses, class Solver, class GoFurther>
  CGP::Eigensolver_result operator()(const CGP::Hermitian_sparse_matrix<Q>& A, const Masses& N,
                                     const Solver& solver, CGP::Block<Q> x0,
                                     const CGP::Eigensolver_options& options,
                                     GoFurther go_further) const
  {
    CGP::Eigensolver_result result;
    result.vectors = std::move(x0);
    result.iterations = options.wanted + wanted_more;
    result.cancelled = !go_further(CGP::Eigensolver_progress());
    result.converged = A.size() == N.size() && A.size() == int(solver.ordering().size());
    return result;
  }
};

struct Problem {
  CGP::Hermitian_sparse_matrix<Q> A = random_definite<Q>(random_pattern(20, 4), 5);
  Eigen::VectorXd masses = (random_numbers(20, 6).array() + 2).matrix();
  CGP::Block<Q> x0 = random_block<Q>(20, 2, 7);
  CGP::internal::Solver_ref<Q> solver;
  CGP::Eigensolver_options options;

  Problem()
  {
    EXPECT_EQ(solver.analyze(A.pattern()), CGP::Solver_status::success);
    EXPECT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  }
};

TEST(Eigensolver_ref, is_lobpcg_by_default)
{
  const Problem p;
  const auto expected = CGP::Lobpcg_eigensolver_traits()(p.A, p.masses, p.solver, p.x0, p.options);
  const auto found = Eigensolver_ref()(p.A, p.masses, p.solver, p.x0, p.options);
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.values, expected.values);
  EXPECT_TRUE(found.vectors == expected.vectors);
}

TEST(Eigensolver_ref, passes_everything_on_to_a_model_with_a_state)
{
  Problem p;
  p.options.wanted = 2;
  const Eigensolver_ref echo = Echo{40};
  const auto found =
      echo(p.A, p.masses, p.solver, p.x0, p.options, [](const auto&) { return false; });
  EXPECT_TRUE(found.vectors == p.x0);
  EXPECT_EQ(found.iterations, 42);
  EXPECT_TRUE(found.cancelled);
  EXPECT_TRUE(found.converged);
}

}  // namespace cgp_test::eigensolver_ref_tests
