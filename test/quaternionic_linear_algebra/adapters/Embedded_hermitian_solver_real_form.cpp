// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Quaternionic_linear_algebra/adapters/Embedded_hermitian_solver.h
#include "support/Real_form_traits.h"

#include "quaternionic_linear_algebra/solver_laws.h"

namespace cgp_test::embedded_hermitian_solver_real_form_tests {

using Traits = Real_form_traits<Supernodal_backend>;
using Solvers = testing::Types<Traits::Solver<double>, Traits::Solver<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Supernodal_real, Hermitian_solver, Solvers);

TEST(Supernodal_real_solver, stores_about_as_many_blocks_as_the_quaternionic_factor)
{
  // The supernodes of both are joined by rules of thumb, so the explicit zeros differ.
  const Pattern grid = grid_pattern(30, 30);
  CGP::Supernodal_cholesky<Quaternion<double>> quaternionic;
  Traits::Solver<Quaternion<double>> real;
  ASSERT_EQ(quaternionic.analyze(*grid), Solver_status::success);
  ASSERT_EQ(real.analyze_like(*grid, quaternionic), Solver_status::success);
  EXPECT_EQ(real.ordering(), quaternionic.ordering());
  const auto blocks = [](const auto& solver) {
    return static_cast<double>(solver.statistics().factor_entries);
  };
  EXPECT_LT(blocks(real), 1.3 * blocks(quaternionic));
  EXPECT_GT(blocks(real), blocks(quaternionic) / 1.3);
}

}  // namespace cgp_test::embedded_hermitian_solver_real_form_tests
