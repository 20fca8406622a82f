// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <vector>

#include "support/bounded_meshes.h"
#include "support/spheres.h"
#include "support/tori.h"

/// Meshes of several components whose elements are interleaved.
namespace cgp_test {

/// several meshes in one
struct Joined_meshes {
  Mesh_view mesh;
  std::vector<std::vector<int>> vertices, faces;  ///< of each mesh: indices in the joined one
};

/// Interleaves vertices and faces of the meshes, so that none of them is contiguous
Joined_meshes interleaved(const std::vector<Mesh_view>& parts);

Mesh_view moved(const Mesh_view& mesh, const Eigen::Vector3d& by);

/// a closed surface, one with a handle, and one with a boundary, of different sizes
std::vector<Mesh_view> surfaces_of_different_types();

}  // namespace cgp_test
