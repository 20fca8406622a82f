// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Fairing.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

inline void require_fairing(Solver_status status)
{
  if (status != Solver_status::success) throw Solver_error("fairing", to_string(status));
}

}  // namespace internal

internal::Fairing::Fairing(const Mesh_view& initial, std::vector<char> is_held)
    : m_is_held(std::move(is_held)),
      m_laplacian(cotan_laplacian(initial)),
      m_matrix(m_laplacian),
      m_areas(vertex_areas(initial))
{
  require_fairing(m_solver.analyze_with_positions(m_laplacian.pattern(), initial.positions()));
}

Points internal::Fairing::operator()(const Mesh_view& mesh, double strength)
{
  const auto is_held = [this](int v) { return m_is_held[static_cast<std::size_t>(v)] != 0; };
  const Eigen::VectorXd mass = m_areas.cwiseProduct(vertex_areas(mesh)).cwiseSqrt();
  const double s = strength * mass.mean();
  int k = 0;
  m_laplacian.for_each_entry(
      [&](int i, int j, double a) { m_matrix.value(k++) = is_held(i) || is_held(j) ? 0 : s * a; });
  require_fairing(m_solver.factorize(m_matrix, mass));
  const Block<double> f = mesh.positions().transpose();
  return (f - rough_part(rough_part(f, s), s)).transpose();
}

// 1 - A = (M + s L)^-1 s L.
Block<double> internal::Fairing::rough_part(const Block<double>& f, double s) const
{
  Block<double> b(f.rows(), f.cols()), x;
  for (Eigen::Index c = 0; c < f.cols(); ++c) b.col(c) = s * (m_laplacian * f.col(c));
  for (Eigen::Index v = 0; v < b.rows(); ++v)
    if (m_is_held[static_cast<std::size_t>(v)]) b.row(v).setZero();
  require_fairing(m_solver.solve(b, x));
  return x;
}

}  // namespace Conformal_geometry_processing
