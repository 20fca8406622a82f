// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Edge_scales.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

internal::Edge_scales::Edge_scales(const Mesh_view& mesh,
                                   std::shared_ptr<const Sparse_pattern> graph)
    : m_ends(mesh.ends()), m_log_lengths(mesh.size_of_edges()), m_normal_matrix(std::move(graph))
{
  const Sparse_pattern& pattern = m_normal_matrix.pattern();
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto [i, j] = mesh.ends(k);
    m_log_lengths[k] = std::log((mesh.position(j) - mesh.position(i)).norm());
    m_normal_matrix.value(pattern.find(j, i)) += .25;
    for (const int v : {i, j}) m_normal_matrix.value(diagonal_position(pattern, v)) += .25;
  }
}

Eigen::VectorXd internal::Edge_scales::residuals(const Points& f, const Eigen::VectorXd& u) const
{
  Eigen::VectorXd c(m_log_lengths.size());
  for (Eigen::Index k = 0; k < c.size(); ++k) {
    const auto [i, j] = m_ends[static_cast<std::size_t>(k)];
    c[k] = std::log((f.col(j) - f.col(i)).norm()) - m_log_lengths[k] - (u[i] + u[j]) / 2;
  }
  return c;
}

double internal::Edge_scales::rounding(const Points& f) const
{
  const Eigen::VectorXd size = f.cwiseAbs().colwise().maxCoeff();
  double largest = 0;  // of coordinates, by the length of their edge
  for (const auto& [i, j] : m_ends)
    largest = (std::max)(largest, (std::max)(size[i], size[j]) / (f.col(j) - f.col(i)).norm());
  return largest * std::numeric_limits<double>::epsilon();
}

Eigen::VectorXd internal::Edge_scales::nearest_scales(const Points& f) const
{
  const Eigen::VectorXd c = residuals(f, Eigen::VectorXd::Zero(f.cols()));
  if (!c.allFinite()) throw Solver_error("Edge_scales", "an edge has no length");
  Block<double> b = Block<double>::Zero(f.cols(), 1), u;
  for (Eigen::Index k = 0; k < c.size(); ++k)
    for (const int v : m_ends[static_cast<std::size_t>(k)]) b(v, 0) += c[k] / 2;
  const auto precondition = make_block_operator<double>([&](const auto& r, auto& z) {
    z.resize(r.rows(), r.cols());
    for (int v = 0; v < m_normal_matrix.size(); ++v)
      z(v, 0) = r(v, 0) / m_normal_matrix.diagonal(v);
  });
  (void)conjugate_gradients(block_operator(m_normal_matrix), precondition, b, u, {1e-14, 200});
  return u.col(0);
}

}  // namespace Conformal_geometry_processing
