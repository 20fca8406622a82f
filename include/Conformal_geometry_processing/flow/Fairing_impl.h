// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_FAIRING_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_FAIRING_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/flow/Fairing.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

inline void require_fairing(Solver_status status)
{
  if (status != Solver_status::success) throw Solver_error("fairing", to_string(status));
}

}  // namespace internal

CGP_INLINE internal::Fairing::Fairing(const Mesh_view& initial)
    : m_laplacian(cotan_laplacian(initial)), m_matrix(m_laplacian), m_areas(vertex_areas(initial))
{
  require_fairing(m_solver.analyze_with_positions(m_laplacian.pattern(), initial.positions()));
}

CGP_INLINE Points internal::Fairing::operator()(const Mesh_view& mesh, double strength)
{
  const Eigen::VectorXd mass = m_areas.cwiseProduct(vertex_areas(mesh)).cwiseSqrt();
  const double s = strength * mass.mean();
  for (int k = 0; k < m_matrix.pattern().size_of_entries(); ++k)
    m_matrix.value(k) = s * m_laplacian.value(k);
  require_fairing(m_solver.factorize(m_matrix, mass));
  const auto smoothed = [&](const Block<double>& f) {
    const Block<double> b = mass.asDiagonal() * f;
    Block<double> x;
    require_fairing(m_solver.solve(b, x));
    return x;
  };
  const Block<double> f = mesh.positions().transpose(), once = smoothed(f);
  return (2 * once - smoothed(once)).transpose();
}

}  // namespace Conformal_geometry_processing

#endif
