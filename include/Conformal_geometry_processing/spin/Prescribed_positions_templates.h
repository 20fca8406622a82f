// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_PRESCRIBED_POSITIONS_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_PRESCRIBED_POSITIONS_TEMPLATES_H

#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/divergence.h>
#include <Conformal_geometry_processing/spin/Prescribed_positions.h>
#include <Conformal_geometry_processing/spin/boundary_planes.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

template <class SolverTraits>
Quaternion_vector<double> internal::Prescribed_positions<SolverTraits>::spins(
    const Hermitian_sparse_matrix<Quaternion<double>>& X) const
{
  const Block<Quaternion<double>> zero =
      Block<Quaternion<double>>::Constant(m_surface.size_of_vertices(), 1, {});
  Block<Quaternion<double>> values = zero;
  for (std::size_t k = 0; k < m_spins.size(); ++k) values(m_frames.vertices[k], 0) = m_spins[k];
  return m_lambda.solve(X, zero, values).col(0);
}

template <class SolverTraits>
double internal::Prescribed_positions<SolverTraits>::residual(
    const Hermitian_sparse_matrix<Quaternion<double>>& X,
    const Quaternion_vector<double>& lambda) const
{
  Quaternion_vector<double> known = lambda;
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    if (!m_lambda.is_given(static_cast<int>(i))) known[i] = {};
  const Quaternion_vector<double> r = X * lambda, b = X * known;
  double left = 0, all = 0;
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    if (!m_lambda.is_given(static_cast<int>(i)))
      left += squared_norm(r[i]), all += squared_norm(b[i]);
  return all > 0 ? std::sqrt(left / all) : 0;
}

template <class SolverTraits>
Points internal::Prescribed_positions<SolverTraits>::positions(const Eigen::MatrixX3d& edges)
{
  const Eigen::VectorXd weights = cotan_weights(m_surface);
  const auto L = cotan_laplacian(m_surface);
  m_positions.factorize(L);
  Block<double> values = Block<double>::Zero(m_surface.size_of_vertices(), 3);
  for (std::size_t k = 0; k < m_frames.vertices.size(); ++k)
    values.row(m_frames.vertices[k]) = m_targets.col(static_cast<Eigen::Index>(k)).transpose();
  return m_positions.solve(L, codifferential(m_surface, weights, edges), values).transpose();
}

template <class SolverTraits>
std::vector<Quaternion<double>> internal::Prescribed_positions<SolverTraits>::spins(
    const Boundary_condition& condition, const std::string& function) const
{
  std::vector<Quaternion<double>> spins;
  std::size_t first = 0;
  for (const std::vector<int>& loop : m_frames.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k)
      spins.push_back(spin_at(condition, first, loop, k, function));
    first += loop.size();
  }
  const std::vector<char> closes = make_continuous(m_frames.loops, spins);
  for (std::size_t l = 0; l < closes.size(); ++l)
    if (!closes[l])
      throw Precondition_error(
          function, "the curve for the boundary loop at vertex " +
                        std::to_string(m_frames.loops[l].front()) +
                        " is twisted by a full turn against it; no continuous spins do that");
  return spins;
}

template <class SolverTraits>
Quaternion<double> internal::Prescribed_positions<SolverTraits>::spin_at(
    const Boundary_condition& condition, std::size_t first, const std::vector<int>& loop,
    std::size_t k, const std::string& function) const
{
  const std::size_t n = loop.size(), next = (k + 1) % n, previous = (k + n - 1) % n;
  const auto target = [&](std::size_t i) -> Eigen::Vector3d {
    return condition.targets.col(static_cast<Eigen::Index>(first + i));
  };
  const auto source = [&](std::size_t i) -> Eigen::Vector3d { return m_surface.position(loop[i]); };
  const auto length = [&](const auto& p) {
    return (p(next) - p(k)).norm() + (p(k) - p(previous)).norm();
  };
  const internal::Boundary_frame frame =
      boundary_frame(circle_tangent(target(previous), target(k), target(next)),
                     condition.normals.col(static_cast<Eigen::Index>(first + k)));
  if (!(frame.determinant() > 0.5))
    throw Precondition_error(function, "the curve folds back, or has its normal along it, at " +
                                           internal::name_of_vertex(loop[k]));
  return boundary_spin(m_frames.frames[first + k], frame, length(target) / length(source));
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Prescribed_positions<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
