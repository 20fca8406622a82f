// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief a point that moves with a surface, an affine combination of its vertices, and the
/// position where it is wanted.
struct Control_point {
  std::vector<int> vertices;
  Eigen::VectorXd weights;  ///< of the vertices; their sum is 1
  Eigen::Vector3d target;
};

/// \relates Control_point
Control_point control_point(int vertex, const Eigen::Vector3d& target);

/// \relates Control_point
/// \brief control points with which a region follows a motion in the mean: its centre, and points
/// on the axes of inertia at the distance of the radius of gyration, for each of the three in whose
/// direction it extends. A vertex counts by a third of the areas of its faces.
/// \param vertices different ones, at least one
/// \param motion of the region, usually rigid; the targets are the moved points
std::vector<Control_point> region_control_points(const Mesh_view& mesh,
                                                 const std::vector<int>& vertices,
                                                 const Eigen::Affine3d& motion);

/// \relates Control_point
/// the points on a surface with given vertex positions, 3 x number of points
Points positions_of(const std::vector<Control_point>& points, const Points& positions);

/// \relates Control_point
/// their targets, 3 x number of points
Points targets_of(const std::vector<Control_point>& points);

/// \relates Control_point
/// \throw Precondition_error if there are no points, a vertex is out of range, a weight or a target
/// is not finite, weights do not add up to 1, or two points are the same vertex. The message names
/// the point
void require_control_points(const std::vector<Control_point>& points, int size_of_vertices,
                            const std::string& function);

}  // namespace Conformal_geometry_processing::internal
