// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/linear_algebra/Petsc_hermitian_solver_traits.h
// Tests include/Conformal_geometry_processing/linear_algebra/Petsc_multigrid.h
#include <Conformal_geometry_processing/linear_algebra/Petsc_hermitian_solver_traits.h>

#include "linear_algebra/solver_laws.h"

namespace cgp_test {

using Traits = CGP::Petsc_hermitian_solver_traits;

// The iteration ends at a residual of 1e-13; condition numbers are below 100.
template <class Scalar>
inline constexpr double error_of_solution<CGP::Petsc_hermitian_solver<Scalar>> = 1e-11;

using Solvers = testing::Types<Traits::Solver<double>, Traits::Solver<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Petsc, Hermitian_solver, Solvers);

}  // namespace cgp_test
