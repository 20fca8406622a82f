// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgConformalClass
/// \brief Directions of a surface along its boundary, from which those of other surfaces of the
/// same connectivity must not differ: for each edge of the boundary, the direction U = t T + n N +
/// b B in the frame of its face, with the edge T, the normal N, and B = T x N out of the surface.
///
/// Tangents concern the ends of the edge, normals and binormals also the third vertex of its face.
class Rim_directions {
 public:
  /// The derivative of a residual by the positions of the vertices of a face
  struct Row {
    std::array<int, 3> vertices;
    Eigen::Matrix3d gradients;  ///< in columns, in the order of the vertices
  };

  /// keeps nothing
  Rim_directions() = default;

  /// \param mesh whose directions are kept
  /// \param direction (t, n, b), of any nonzero length
  Rim_directions(const Mesh_view& mesh, const Eigen::Vector3d& direction);

  /// the number of residuals: two for each edge of the boundary
  Eigen::Index size_of_rows() const { return 2 * m_normals.cols(); }

  /// \brief The components of U(f) orthogonal to the kept directions: angles in radians, to first
  /// order.
  Eigen::VectorXd residuals(const Points& f) const;

  /// the derivatives of the residuals
  std::vector<Row> derivative(const Points& f) const;

 private:
  Eigen::Vector3d m_direction;
  std::vector<std::array<int, 3>> m_faces;  // of each edge: its ends, and the third vertex
  Points m_normals, m_others;               // two unit vectors orthogonal to each kept direction
};

}  // namespace Conformal_geometry_processing::internal
