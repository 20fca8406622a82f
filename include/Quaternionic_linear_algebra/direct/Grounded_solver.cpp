// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>

#include <Quaternionic_linear_algebra/exceptions.h>

#include <string>

namespace Conformal_geometry_processing {

internal::Grounded_solver::Grounded_solver(std::shared_ptr<const Sparse_pattern> pattern,
                                           const Spin_solvers& solvers)
    : m_grounded(std::move(pattern)), m_solver(solvers.solver<double>())
{
  check("analysis", m_solver.analyze(m_grounded.pattern()));
}

void internal::Grounded_solver::factorize(const Hermitian_sparse_matrix<double>& L)
{
  if (!(L.pattern() == m_grounded.pattern()))
    throw Solver_error("Grounded_solver::factorize", to_string(Solver_status::wrong_state));
  for (int k = 0; k < L.pattern().size_of_entries(); ++k) m_grounded.value(k) = L.value(k);
  // Row and column 0 consist of column 0 of the lower triangle. Multiplication by zero, unlike
  // assignment, propagates values that are not finite.
  for (int k = 0; k < L.pattern().offsets[1]; ++k) m_grounded.value(k) *= 0;
  m_grounded.value(0) += 1;
  check("factorization", m_solver.factorize(m_grounded, {}));
}

Block<double> internal::Grounded_solver::solve(Block<double> b) const
{
  const Eigen::RowVectorXd unreachable = b.colwise().mean();
  b.rowwise() -= unreachable;
  b.row(0).setZero();
  Block<double> x;
  check("solution", m_solver.solve(b, x));
  const Eigen::RowVectorXd mean = x.colwise().mean();
  x.rowwise() -= mean;
  return x;
}

void internal::Grounded_solver::check(const char* step, Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("Grounded_solver",
                       std::string(step) + " of the grounded matrix failed: " + to_string(status));
}

}  // namespace Conformal_geometry_processing
