// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Potential_metric.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

Potential_metric::Potential_metric(const Dirac_system& system, double s)
    : m_areas(system.areas()),
      m_matrix(system.matrix().shared_pattern()),
      m_coupled(system.solver().another<double>())
{
  const Surface_ref& surface = system.surface();
  assemble_cotan_laplacian(surface, s * cotan_weights(surface), m_matrix);
  for (int v = 0; v < m_matrix.size(); ++v)
    m_matrix.value(diagonal_position(m_matrix.pattern(), v)) += m_areas[v];
  check(m_coupled.analyze_like(m_matrix.pattern(), system.solver()));
}

void Potential_metric::couple(double w)
{
  check(m_coupled.factorize(m_matrix, w * m_areas));
}

Eigen::VectorXd Potential_metric::solve_coupled(const Eigen::VectorXd& b) const
{
  Block<double> x;
  check(m_coupled.solve(b, x));
  return x;
}

Eigen::MatrixXd Potential_metric::apply(const Eigen::MatrixXd& d) const
{
  Eigen::MatrixXd y(d.rows(), d.cols());
  for (Eigen::Index k = 0; k < d.cols(); ++k) m_matrix.multiply(d.col(k), y.col(k));
  return y;
}

void Potential_metric::check(Solver_status status)
{
  if (status != Solver_status::success) throw Solver_error("Potential_metric", to_string(status));
}

}  // namespace Conformal_geometry_processing::internal
