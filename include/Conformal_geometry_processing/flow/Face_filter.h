// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \brief points of a flow that suit the faces of its input.
///
/// Where faces are thin, what is smooth on the triangulation of the flow may be rough on them, as
/// the same points are joined by other edges, and steps cannot smooth faces of the triangulation
/// that are thin themselves, of prisms for instance. That roughness is as narrow as an edge, so a
/// filter takes it off: with A = (M + S L)^-1 M, the cotan Laplacian L and vertex areas M of the
/// input, and S their mean,
///
///     f - (1 - A)^2 f,
///
/// which leaves what is wide as it is, up to the fourth power of the edge length by the width. L
/// does not depend on scale, so an edge is as wide as another however the surface has changed.
class Face_filter {
 public:
  /// \param input closed. Costs one factorization of a real matrix
  /// \throw Solver_error if the matrix cannot be factored
  Face_filter(const Mesh_view& input, const Spin_solvers& solvers);

  /// \brief the filtered positions, 3 x |V|, with the same mean by the vertex areas of the input.
  /// Costs two solutions.
  Points settled(const Points& positions) const;

 private:
  Points averaged(const Points& positions) const;  // A f

  Eigen::VectorXd m_masses;  // M / S
  Solver_ref<double> m_solver;
};

}  // namespace Conformal_geometry_processing::internal
