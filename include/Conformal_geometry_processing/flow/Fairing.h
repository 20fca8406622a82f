// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_cholesky.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgFlow
/// \brief smooths surfaces within about the conformal class of an initial one: f <- f - (1 - A)^2 f
/// with A = (M + s L_0)^-1 M.
///
/// L_0 is the Laplacian of the *initial* surface, which is that of each conformally equivalent one
/// [Kazhdan, Solomon and Ben-Chen 2012]. (1 - A)^2 takes the high frequencies away, and leaves low
/// ones to second order: a single 1 - A would shrink the surface. M is the geometric mean of the
/// vertex areas of the initial and of the present surface: with those of the present one, even a
/// small s would be a large step wherever it has shrunk by orders of magnitude; with those of the
/// initial one, parts that have grown would hardly move. s is a multiple of the mean of M.
///
/// Vertices at a boundary are held, for a surface would shrink from its boundary; then minimal
/// surfaces stay as they are.
///
/// The ordering is computed once. One factorization of a real matrix on the vertices, and two
/// solves of three columns.
class Fairing {
 public:
  /// \param initial the initial surface
  /// \param is_held |V|, vertices that do not move: those at a boundary, at least
  /// \throw Solver_error if the analysis fails
  Fairing(const Mesh_view& initial, std::vector<char> is_held);

  /// \param mesh a surface of the connectivity of the initial one
  /// \param strength s by the mean of M
  /// \throw Solver_error if the factorization fails
  Points operator()(const Mesh_view& mesh, double strength);

 private:
  /// (1 - A) f, zero where vertices are held
  Block<double> rough_part(const Block<double>& f, double s) const;

  std::vector<char> m_is_held;
  Hermitian_sparse_matrix<double> m_laplacian, m_matrix;
  Eigen::VectorXd m_areas;  // of the vertices, of the initial surface
  Supernodal_cholesky<double> m_solver;
};

}  // namespace Conformal_geometry_processing::internal
