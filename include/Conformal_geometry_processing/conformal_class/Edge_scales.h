// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgConformalClass
/// \brief The lengths l_ij of a mesh, from which those of a surface are to differ by factors at the
/// vertices: |f_j - f_i| = l_ij exp((u_i + u_j) / 2), discrete conformal equivalence.
///
/// All functions are invariant under motions of f; scaling of f adds a constant to u.
class Edge_scales {
 public:
  /// \param graph the `vertex_graph()` of the mesh
  Edge_scales(const Mesh_view& mesh, std::shared_ptr<const Sparse_pattern> graph);

  const std::vector<std::array<int, 2>>& ends() const { return m_ends; }

  /// \brief c_ij = log |f_j - f_i| - log l_ij - (u_i + u_j) / 2, |E| numbers; not finite where an
  /// edge has no length.
  Eigen::VectorXd residuals(const Points& f, const Eigen::VectorXd& u) const;

  /// \brief How exactly positions in double precision can hold the residuals: the largest change of
  /// log |f_j - f_i| when coordinates of the ends are rounded.
  double rounding(const Points& f) const;

  /// \brief The u of least squares of the residuals.
  ///
  /// Its normal equations, the signless Laplacian, are well conditioned on every mesh with
  /// triangles: conjugate gradients need about 30 products.
  /// \throw Solver_error if an edge of f has no length
  Eigen::VectorXd nearest_scales(const Points& f) const;

 private:
  std::vector<std::array<int, 2>> m_ends;
  Eigen::VectorXd m_log_lengths;
  Hermitian_sparse_matrix<double> m_normal_matrix;
};

}  // namespace Conformal_geometry_processing::internal
