// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Surface_input.h"

#include <Conformal_geometry_processing/spin/Control_point.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace conformal {

/// where the user wants a vertex, or a region, in units of the mesh
struct Target {
  std::vector<int> vertices;  ///< of the mesh; at least one
  bool is_region = false;
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< of a region, about its centre
};

/// \brief Reads the targets of a file,
///
///     {"targets": [{"vertex": 12, "to": [x, y, z]},
///                  {"vertex": 13, "move": [x, y, z]},
///                  {"vertices": [14, 15, 16], "move": [x, y, z]},
///                  {"box": [[x, y, z], [x, y, z]], "turn": [ax, ay, az, degrees]}]}
///
/// where vertices have their numbers in the file of the surface, before repairs, and those in a box
/// are a region. Without `to`, `move` and `turn` it stays where it is.
/// \throws Read_error if the file cannot be read, naming the target that makes no sense; Failure if
/// the surface has not the vertices
std::vector<Target> read_targets(const Surface_input& input, const std::string& path);

/// \brief The control points of the targets on a surface.
/// \param vertices of the mesh of the targets that are the surface, in order
std::vector<CGP::internal::Control_point> control_points(const std::vector<Target>& targets,
                                                         const CGP::Mesh_view& surface,
                                                         const std::vector<int>& vertices);

}  // namespace conformal
