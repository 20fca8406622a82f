// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Control_point.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief weights in a `Region_of_interest` where something happens: 0 in those of its parts, faces
/// with a vertex of positive weight that are connected, that have no control point.
/// \param weights |V|, or empty, as is the result then
/// \throw Precondition_error see `require_control_points()`
Eigen::VectorXd weights_at(const std::vector<Control_point>& points, const Mesh_view& mesh,
                           Eigen::VectorXd weights, const std::string& function);

/// \throw Precondition_error if a weight, one per vertex, is not in [0, 1], or none is 1
void require_region(const Mesh_view& mesh, const Eigen::VectorXd& weights,
                    const std::string& function);

/// \brief the part of a surface that an edit may change, with a collar where the edit fades out.
///
/// Each vertex has a weight w: 1 follows the edit, 0 stays, to the bit. Those between are the
/// collar: they move by the share s = w^2 (3 - 2 w) of the edit's displacement, whose slope is zero
/// at both ends, so that normals are continuous. No displacement but a similarity is conformal and
/// fades out; the collar has the distortion, which falls with its width. The edit is made on the
/// faces with a vertex of positive weight alone, and anchors, control points that are where they
/// were, let it displace the collar little.
class Region_of_interest {
 public:
  /// \param weights |V|
  /// \throw as `require_region()`, and Precondition_error if the part is not connected
  Region_of_interest(const Mesh_view& mesh, const Eigen::VectorXd& weights,
                     const std::string& function);

  /// the faces with a vertex of positive weight
  const Mesh_view& mesh() const { return m_part.mesh; }

  /// the indices of its vertices in the whole mesh
  const std::vector<int>& vertices() const { return m_part.vertices; }

  /// what holds the collar, in the part; none if all weights are 1
  const std::vector<Control_point>& anchors() const { return m_anchors; }

  /// \brief control points of the whole mesh in the part.
  /// \throw Precondition_error if one has a vertex whose weight is not 1. The message names it
  std::vector<Control_point> in_part(std::vector<Control_point> points,
                                     const std::string& function) const;

  /// \brief fades out an edit of the part.
  /// \param positions, lambda of the edited part; where the weight is 0, the positions become those
  /// of the mesh, and lambda 1
  void fade(Points& positions, Quaternion_vector<double>& lambda) const;

  /// of the map from the faces of the collar to those with other positions of the part; none if all
  /// weights are 1
  std::optional<Conformality> collar_conformality(const Points& positions,
                                                  const Quaternion_vector<double>& lambda) const;

  /// the mesh with other positions of the part; all other vertices stay, to the bit
  Points in_whole(const Points& positions) const;

  /// the spins of the mesh, 1 outside of the part
  Quaternion_vector<double> in_whole(const Quaternion_vector<double>& lambda) const;

  /// numbers of the vertices of the mesh, 0 outside of the part
  Eigen::VectorXd in_whole(const Eigen::VectorXd& numbers) const;

 private:
  void choose_anchors();

  Points m_positions;  // of the mesh
  Mesh_component m_part;
  Eigen::VectorXd m_weights, m_shares;  // of the vertices of the part: w, s
  std::vector<int> m_in_part;           // the vertices of the mesh there; -1 outside
  std::vector<Control_point> m_anchors;
};

}  // namespace Conformal_geometry_processing::internal
