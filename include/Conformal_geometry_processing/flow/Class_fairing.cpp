// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Class_fairing.h>

#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/choose_ordering.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

// The weight of the constraints against K. The class is reached by steps with one factor, each of
// which leaves about 1 / weight of the residuals; a larger one costs digits.
constexpr double relative_class_weight = 1e8;
constexpr double class_scale_weight = 1e-6;  // of |du|^2, so that the matrix is definite
// Of the logarithms of lengths: what is aimed at, and what is enough for a step, for errors of
// steps do not add up. On isothermic surfaces, such as spheres, the last digits converge slowly.
constexpr double class_residual = 2.5e-11, largest_class_residual = 1e-7, slow = .9;
constexpr int most_steps_to_class = 20;
constexpr double least_step = 1e-4;

}  // namespace internal

internal::Class_fairing::Class_fairing(const Fairing_patch& patch)
    : m_patch(patch),
      m_bending(patch),
      m_matrix(std::make_shared<const Sparse_pattern>(expanded_pattern(*m_bending.pattern(), 4))),
      m_scales(Eigen::VectorXd::Zero(patch.size()))
{
  const Mesh_view& mesh = patch.mesh();
  for (const auto& [i, j] : mesh.ends())
    if (patch.is_free(i) || patch.is_free(j))
      m_edges.push_back({i, j, patch.unknown(i), patch.unknown(j),
                         std::log((mesh.position(j) - mesh.position(i)).norm())});
  Points positions(3, patch.size());
  for (int k = 0; k < patch.size(); ++k) positions.col(k) = mesh.position(patch.free_vertex(k));
  const int factorizations = 30;
  const Ordering order = choose_ordering(*m_bending.pattern(), &positions, factorizations);
  require_fairing_solver(m_solver.analyze(m_matrix.pattern(), expanded_ordering(order, 4)));
}

// Entry (row, column) of a block of a column of blocks, 0 for the diagonal one.
double& internal::Class_fairing::entry(int block_column, int block, int row, int column)
{
  const auto& offsets = m_matrix.pattern().offsets;
  const int first = offsets[static_cast<std::size_t>(4 * block_column + column)] - column;
  return m_matrix.value(first + 4 * block + row);
}

void internal::Class_fairing::assemble(const Bending_energy& energy)
{
  const Sparse_pattern& pattern = *m_bending.pattern();
  Eigen::VectorXd K = Eigen::VectorXd::Zero(pattern.size_of_entries());
  m_bending.assemble(energy, [&](int k, double x) { K[k] += x; });
  m_matrix.set_zero();
  double trace = 0, constraints = 0;
  for (int j = 0; j < pattern.size(); ++j) {
    const int first = pattern.offsets[static_cast<std::size_t>(j)];
    for (int k = first; k < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++k)
      for (int c = 0; c < 3; ++c) entry(j, k - first, c, c) += K[k];
    entry(j, 0, 3, 3) += class_scale_weight;
    trace += 3 * K[first];
  }
  m_directions.resize(3, static_cast<Eigen::Index>(m_edges.size()));
  for (Eigen::Index k = 0; k < m_directions.cols(); ++k) {
    const Edge& edge = m_edges[static_cast<std::size_t>(k)];
    const Eigen::Vector3d e = energy.mesh().position(edge.j) - energy.mesh().position(edge.i);
    m_directions.col(k) = e / e.squaredNorm();
    constraints += ((edge.unknown_i >= 0) + (edge.unknown_j >= 0)) / e.squaredNorm();
  }
  m_weight = relative_class_weight * trace / constraints;
  for (std::size_t k = 0; k < m_edges.size(); ++k)
    add_edge(m_edges[k], m_directions.col(static_cast<Eigen::Index>(k)));
}

void internal::Class_fairing::add_edge(const Edge& edge, const Eigen::Vector3d& direction)
{
  Eigen::Vector4d at_i, at_j;
  at_i << -direction, -.5;
  at_j << direction, -.5;
  const auto add = [this](int row, int column, const Eigen::Vector4d& a, const Eigen::Vector4d& b) {
    const Sparse_pattern& pattern = *m_bending.pattern();
    const int block = pattern.find(row, column) - pattern.offsets[static_cast<std::size_t>(column)];
    for (int c = 0; c < 4; ++c)
      for (int r = row == column ? c : 0; r < 4; ++r)
        entry(column, block, r, c) += m_weight * a[r] * b[c];
  };
  const int i = edge.unknown_i, j = edge.unknown_j;
  if (i >= 0) add(i, i, at_i, at_i);
  if (j >= 0) add(j, j, at_j, at_j);
  if (i >= 0 && j >= 0) i > j ? add(i, j, at_i, at_j) : add(j, i, at_j, at_i);
}

Eigen::VectorXd internal::Class_fairing::residuals(const Points& f, const Eigen::VectorXd& u) const
{
  const auto scale = [&](int k) { return k < 0 ? 0 : u[k]; };
  Eigen::VectorXd c(static_cast<Eigen::Index>(m_edges.size()));
  for (std::size_t k = 0; k < m_edges.size(); ++k) {
    const Edge& e = m_edges[k];
    c[static_cast<Eigen::Index>(k)] = std::log((f.col(e.j) - f.col(e.i)).norm()) - e.log_length -
                                      (scale(e.unknown_i) + scale(e.unknown_j)) / 2;
  }
  return c;
}

internal::Class_fairing::State internal::Class_fairing::advanced(const State& state,
                                                                 const Points& g) const
{
  Block<double> b = Block<double>::Zero(m_matrix.size(), 1), x;
  for (int k = 0; k < m_patch.size(); ++k) b.block<3, 1>(4 * k, 0) = -g.col(k);
  for (Eigen::Index k = 0; k < m_directions.cols(); ++k) {
    const Edge& edge = m_edges[static_cast<std::size_t>(k)];
    const double c = m_weight * state.residuals[k];
    for (const auto& [unknown, sign] : {std::pair{edge.unknown_i, 1}, {edge.unknown_j, -1}}) {
      if (unknown < 0) continue;
      b.block<3, 1>(4 * unknown, 0) += sign * c * m_directions.col(k);
      b(4 * unknown + 3, 0) += c / 2;
    }
  }
  require_fairing_solver(m_solver.solve(b, x));
  const auto at_vertices = x.col(0).reshaped(4, m_patch.size());
  State next{moved(m_patch, state.f, at_vertices.topRows<3>()),
             state.u + at_vertices.row(3).transpose(),
             {}};
  next.residuals = residuals(next.f, next.u);
  return next;
}

bool internal::Class_fairing::return_to_class(State& state) const
{
  const auto distance = [](const State& s) { return s.residuals.lpNorm<Eigen::Infinity>(); };
  const Points none = Points::Zero(3, m_patch.size());
  for (int k = 0; k < most_steps_to_class && distance(state) > class_residual; ++k) {
    State next = advanced(state, none);
    if (!(distance(next) < slow * distance(state))) break;  // also if it is not a number
    state = std::move(next);
  }
  return distance(state) <= largest_class_residual;
}

internal::Fairing_step internal::Class_fairing::step(const Bending_energy& present)
{
  assemble(present);
  factorize_fairing(m_solver, m_matrix);
  const Points& f = present.mesh().positions();
  const Points all = present.gradient();
  Points g(3, m_patch.size());
  for (int k = 0; k < m_patch.size(); ++k) g.col(k) = all.col(m_patch.free_vertex(k));
  const State start{f, m_scales, residuals(f, m_scales)};
  Fairing_step next;
  for (m_length = (std::min)(1., 2 * m_length); m_length > least_step; m_length /= 2) {
    State state = advanced(start, m_length * g);
    next.is_lower =
        return_to_class(state) && Bending_energy(m_patch, state.f).value() < present.value();
    next.f = std::move(state.f);
    if (!next.is_lower) continue;
    m_scales = std::move(state.u);
    break;
  }
  return next;
}

void internal::Class_fairing::polish(Points& f)
{
  assemble(Bending_energy(m_patch, f));
  factorize_fairing(m_solver, m_matrix);
  State state{f, m_scales, residuals(f, m_scales)};
  return_to_class(state);
  f = std::move(state.f);
}

}  // namespace Conformal_geometry_processing
