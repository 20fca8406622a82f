// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Face_filter.h>

#include <Conformal_geometry_processing/measure/Realised_curvature.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

namespace Conformal_geometry_processing::internal {

Face_filter::Face_filter(const Mesh_view& input, const Spin_solvers& solvers)
    : m_solver(solvers.solver<double>())
{
  const Eigen::VectorXd areas = vertex_areas(input);
  m_masses = areas / areas.mean();
  const Hermitian_sparse_matrix<double> L = cotan_laplacian(input);
  check_smoothing("analysis", m_solver.analyze(L.pattern()));
  check_smoothing("factorization", m_solver.factorize(L, m_masses));
}

Points Face_filter::averaged(const Points& positions) const
{
  Block<double> smooth;
  const Block<double> b = m_masses.asDiagonal() * positions.transpose();
  check_smoothing("solution", m_solver.solve(b, smooth));
  return smooth.transpose();
}

Points Face_filter::settled(const Points& positions) const
{
  return averaged(2 * positions - averaged(positions));
}

}  // namespace Conformal_geometry_processing::internal
