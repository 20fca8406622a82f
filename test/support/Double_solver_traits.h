// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

namespace cgp_test {

/// the library's solvers, whose preconditioners are in double precision too
struct Double_solver_traits {
  template <class Scalar>
  struct Solver : Conformal_geometry_processing::Supernodal_cholesky<Scalar> {
    auto factorize_preconditioner(
        const Conformal_geometry_processing::Hermitian_sparse_matrix<Scalar>& A,
        const Conformal_geometry_processing::Vector<double>& shift)
    {
      return this->factorize(A, shift);
    }
  };
};

}  // namespace cgp_test
