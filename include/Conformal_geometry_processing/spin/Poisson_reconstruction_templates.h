// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_POISSON_RECONSTRUCTION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_POISSON_RECONSTRUCTION_TEMPLATES_H

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <cmath>
#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits>
Poisson_reconstruction<SolverTraits>::Poisson_reconstruction(
    const Surface_ref& surface, std::shared_ptr<const Sparse_pattern> pattern)
    : m_surface(surface), m_L(pattern), m_solver(std::move(pattern))
{
  update_geometry();
}

template <class SolverTraits>
void Poisson_reconstruction<SolverTraits>::update_geometry()
{
  m_weights = cotan_weights(m_surface);
  assemble_cotan_laplacian(m_surface, m_weights, m_L);
  m_solver.factorize(m_L);
}

template <class SolverTraits>
Points Poisson_reconstruction<SolverTraits>::positions(const Eigen::MatrixX3d& edges) const
{
  return m_solver.solve(codifferential(m_surface, m_weights, edges)).transpose();
}

template <class SolverTraits>
Eigen::MatrixX3d Poisson_reconstruction<SolverTraits>::edge_gradient(const Points& y) const
{
  return m_weights.asDiagonal() * differential(m_surface, m_solver.solve(y.transpose()));
}

template <class SolverTraits>
double Poisson_reconstruction<SolverTraits>::residual(const Points& f,
                                                      const Eigen::MatrixX3d& edges) const
{
  return internal::closure_residual(m_surface, m_weights, f, edges);
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Poisson_reconstruction<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
