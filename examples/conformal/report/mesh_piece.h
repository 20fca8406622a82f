// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// some faces of a mesh, and the same faces in the same order as a mesh of their own
struct Mesh_piece {
  std::vector<int> faces;
  CGP::Mesh_view mesh;
};

/// \brief Cuts out the faces of one region. If they meet only in a vertex, the piece has copies of
/// it, so that it is a manifold if the mesh is one.
/// \param faces all of one region \param region of each face of the mesh
Mesh_piece mesh_piece(const CGP::Mesh_view& mesh, std::vector<int> faces,
                      const std::vector<int>& region);

}  // namespace conformal
