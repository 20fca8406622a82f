// Tests examples/Ldl_solver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "../../examples/Ldl_solver.h"

#include "quaternionic_linear_algebra/solver_laws.h"

namespace cgp_test::ldl_solver_tests {

using Models = testing::Types<Ldl_solver<double>, Ldl_solver<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Ldl, Hermitian_solver, Models);

}  // namespace cgp_test::ldl_solver_tests
