// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Class_equations.h>

#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/choose_ordering.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

inline std::vector<int> all_free(int n)
{
  std::vector<int> free(static_cast<std::size_t>(n));
  std::iota(free.begin(), free.end(), 0);
  return free;
}

}  // namespace internal

internal::Edge_scales::Edge_scales(const Mesh_view& mesh)
    : Edge_scales(mesh, all_free(mesh.size_of_vertices()))
{}

internal::Edge_scales::Edge_scales(const Mesh_view& mesh, const std::vector<int>& free)
{
  for (const auto& [i, j] : mesh.ends()) {
    const std::array<int, 2> of_ends{free[static_cast<std::size_t>(i)],
                                     free[static_cast<std::size_t>(j)]};
    if ((std::max)(of_ends[0], of_ends[1]) >= 0)
      m_edges.push_back({{i, j}, of_ends, std::log((mesh.position(j) - mesh.position(i)).norm())});
  }
}

Eigen::VectorXd internal::Edge_scales::residuals(const Points& f, const Eigen::VectorXd& u) const
{
  Eigen::VectorXd c(static_cast<Eigen::Index>(m_edges.size()));
  for (Eigen::Index k = 0; k < c.size(); ++k) {
    const auto& [ends, free, log_length] = m_edges[static_cast<std::size_t>(k)];
    c[k] = std::log((f.col(ends[1]) - f.col(ends[0])).norm()) - log_length;
    for (const int v : free)
      if (v >= 0) c[k] -= u[v] / 2;
  }
  return c;
}

double internal::Edge_scales::rounding(const Points& f) const
{
  const Eigen::VectorXd size = f.cwiseAbs().colwise().maxCoeff();
  double largest = 0;  // of coordinates, by the length of their edge
  for (const Edge& edge : m_edges) {
    const auto [i, j] = edge.ends;
    largest = (std::max)(largest, (std::max)(size[i], size[j]) / (f.col(j) - f.col(i)).norm());
  }
  return largest * std::numeric_limits<double>::epsilon();
}

Eigen::VectorXd internal::Edge_scales::nearest_scales(const Points& f) const
{
  const Eigen::VectorXd c = residuals(f, Eigen::VectorXd::Zero(f.cols()));
  if (!c.allFinite()) throw Solver_error("Edge_scales", "an edge has no length");
  Block<double> b = Block<double>::Zero(f.cols(), 1), u;
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(f.cols());
  for (Eigen::Index k = 0; k < c.size(); ++k)
    for (const int v : m_edges[static_cast<std::size_t>(k)].ends)
      b(v, 0) += c[k] / 2, diagonal[v] += .25;
  const auto multiply = make_block_operator<double>([&](const auto& x, auto& y) {
    y.setZero(x.rows(), x.cols());
    for (const Edge& edge : m_edges) {
      const auto [i, j] = edge.ends;
      const double sum = (x(i, 0) + x(j, 0)) / 4;
      y(i, 0) += sum, y(j, 0) += sum;
    }
  });
  const auto precondition = make_block_operator<double>(
      [&](const auto& r, auto& z) { z = r.array().colwise() / diagonal.array(); });
  Conjugate_gradients_options options;
  options.tolerance = 1e-14;
  options.max_iterations = 200;
  (void)conjugate_gradients(multiply, precondition, b, u, options);
  return u.col(0);
}

internal::Class_form::Class_form(Edge_scales scales, const Sparse_pattern& graph)
    : m_scales(std::move(scales)),
      m_graph(graph),
      m_matrix(std::make_shared<const Sparse_pattern>(expanded_pattern(graph, 4)))
{}

Solver_status internal::Class_form::analyze(Supernodal_cholesky<double>& solver,
                                            const Points& positions) const
{
  const int factorizations = 10;  // a few for each surface, of which there are many
  const Ordering order = choose_ordering(m_graph, &positions, factorizations);
  return solver.analyze(m_matrix.pattern(), expanded_ordering(order, 4));
}

void internal::Class_form::linearize(const Points& f)
{
  m_matrix.set_zero();
  m_weight = 0;
  m_directions.resize(3, static_cast<Eigen::Index>(m_scales.edges().size()));
  for (Eigen::Index k = 0; k < m_directions.cols(); ++k) {
    const auto [i, j] = m_scales.edges()[static_cast<std::size_t>(k)].ends;
    const Eigen::Vector3d e = f.col(j) - f.col(i);
    m_directions.col(k) = e / e.squaredNorm();
  }
}

// Rows of short edges are larger than others by many orders of magnitude: so is what is added.
Solver_status internal::factorize_definite(Supernodal_cholesky<double>& solver,
                                           const Hermitian_sparse_matrix<double>& A, double most)
{
  Eigen::VectorXd diagonal(A.size());
  for (int j = 0; j < A.size(); ++j) diagonal[j] = std::abs(A.diagonal(j));
  Solver_status status = solver.factorize(A, {});
  for (double share = 1e-13; share < most && status == Solver_status::not_positive_definite;
       share *= 100)
    status = solver.factorize(A, share * diagonal);
  return status;
}

// Of the diagonal, the pattern has the lower half; its block is the first of its columns.
void internal::Class_form::add(int row, int column, const Eigen::Matrix4d& block)
{
  if (row < column) return add(column, row, block.transpose());
  const int below = m_graph.find(row, column) - m_graph.offsets[static_cast<std::size_t>(column)];
  for (int c = 0; c < 4; ++c) {
    const int first = m_matrix.pattern().offsets[static_cast<std::size_t>(4 * column + c)] - c;
    for (int r = row == column ? c : 0; r < 4; ++r)
      m_matrix.value(first + 4 * below + r) += block(r, c);
  }
}

void internal::Class_form::add_equations(double w)
{
  m_weight += w;
  for (Eigen::Index k = 0; k < m_directions.cols(); ++k) {
    const auto [i, j] = m_scales.edges()[static_cast<std::size_t>(k)].free;
    Eigen::Vector4d at_i, at_j;
    at_i << -m_directions.col(k), -.5;
    at_j << m_directions.col(k), -.5;
    if (i >= 0) add(i, i, w * at_i * at_i.transpose());
    if (j >= 0) add(j, j, w * at_j * at_j.transpose());
    if (i >= 0 && j >= 0) add(j, i, w * at_j * at_i.transpose());
  }
}

Block<double> internal::Class_form::right_hand_side(const Eigen::VectorXd& c) const
{
  Block<double> b = Block<double>::Zero(m_matrix.size(), 1);
  for (Eigen::Index k = 0; k < m_directions.cols(); ++k) {
    const auto [i, j] = m_scales.edges()[static_cast<std::size_t>(k)].free;
    for (const auto& [v, sign] : {std::pair{i, 1}, {j, -1}}) {
      if (v < 0) continue;
      b.block<3, 1>(4 * v, 0) += sign * m_weight * c[k] * m_directions.col(k);
      b(4 * v + 3, 0) += m_weight * c[k] / 2;
    }
  }
  return b;
}

}  // namespace Conformal_geometry_processing
