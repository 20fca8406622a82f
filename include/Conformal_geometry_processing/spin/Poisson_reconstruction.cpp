// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

namespace Conformal_geometry_processing {

Poisson_reconstruction::Poisson_reconstruction(const Surface_ref& surface,
                                               std::shared_ptr<const Sparse_pattern> pattern,
                                               const Spin_solvers& solvers)
    : m_surface(surface), m_L(pattern), m_solver(std::move(pattern), solvers)
{
  update_geometry();
}

void Poisson_reconstruction::update_geometry()
{
  m_weights = cotan_weights(m_surface);
  assemble_cotan_laplacian(m_surface, m_weights, m_L);
  m_solver.factorize(m_L);
}

Points Poisson_reconstruction::positions(const Eigen::MatrixX3d& edges) const
{
  return m_solver.solve(codifferential(m_surface, m_weights, edges)).transpose();
}

Eigen::MatrixXd Poisson_reconstruction::edge_gradient(const Eigen::MatrixXd& y) const
{
  return m_weights.asDiagonal() * differential(m_surface, m_solver.solve(y));
}

double Poisson_reconstruction::residual(const Points& f, const Eigen::MatrixX3d& edges) const
{
  return internal::closure_residual(m_surface, m_weights, f, edges);
}

}  // namespace Conformal_geometry_processing
