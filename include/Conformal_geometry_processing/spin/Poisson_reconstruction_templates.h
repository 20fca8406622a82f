// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_POISSON_RECONSTRUCTION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_POISSON_RECONSTRUCTION_TEMPLATES_H

#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/divergence.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include <Eigen/Core>

#include <cmath>
#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits, class Surface>
Poisson_reconstruction<SolverTraits, Surface>::Poisson_reconstruction(
    const Surface& mesh, std::shared_ptr<const Sparse_pattern> pattern)
    : m_mesh(mesh), m_L(pattern), m_solver(std::move(pattern))
{
  update_geometry();
}

template <class SolverTraits, class Surface>
void Poisson_reconstruction<SolverTraits, Surface>::update_geometry()
{
  m_weights = cotan_weights(m_mesh);
  assemble_cotan_laplacian(m_mesh, m_weights, m_L);
  m_solver.factorize(m_L);
}

template <class SolverTraits, class Surface>
Points Poisson_reconstruction<SolverTraits, Surface>::positions(const Eigen::MatrixX3d& edges) const
{
  return m_solver.solve(codifferential(m_mesh, m_weights, edges)).transpose();
}

template <class SolverTraits, class Surface>
double Poisson_reconstruction<SolverTraits, Surface>::residual(const Points& f,
                                                               const Eigen::MatrixX3d& edges) const
{
  double difference = 0, total = 0;
  for (int k = 0; k < m_mesh.size_of_edges(); ++k) {
    const Eigen::Vector3d e = edges.row(k);
    const Eigen::Vector3d d = f.col(m_mesh.ends(k)[1]) - f.col(m_mesh.ends(k)[0]);
    difference += std::abs(m_weights[k]) * (d - e).squaredNorm();
    total += std::abs(m_weights[k]) * e.squaredNorm();
  }
  return std::sqrt(difference / total);
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Poisson_reconstruction<Default_solver_traits, Mesh_view>;
extern template class Poisson_reconstruction<Default_solver_traits, Delaunay_view>;

}  // namespace Conformal_geometry_processing
#endif

#endif
