// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>
#include <Quaternionic_linear_algebra/exceptions.h>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// \brief the solver of all implicit methods: this library's own, in real numbers.
///
/// As the flow of this library does, it orders and analyzes once and factorizes as often as the
/// matrix changes.
class Real_cholesky {
 public:
  Real_cholesky(const CGP::Sparse_pattern& pattern, const CGP::Points& positions)
  {
    check(m_solver.analyze_with_positions(pattern, positions));
  }

  /// \pre A is symmetric and, up to rounding, positive definite
  void factorize(const CGP::Hermitian_sparse_matrix<double>& A)
  {
    check(m_solver.factorize(A, {}));
  }

  /// x with A x = b for each coordinate, 3 x |V|
  CGP::Points solve(const CGP::Points& b) const
  {
    CGP::Block<double> x;
    check(m_solver.solve(b.transpose(), x));
    return x.transpose();
  }

 private:
  static void check(CGP::Solver_status status)
  {
    if (status != CGP::Solver_status::success)
      throw CGP::Solver_error("benchmark_fairing", to_string(status));
  }

  CGP::Supernodal_cholesky<double> m_solver;
};

}  // namespace cgp_benchmark
