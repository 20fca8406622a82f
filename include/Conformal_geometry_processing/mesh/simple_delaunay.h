// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <array>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief The mesh with the connectivity of its intrinsic Delaunay triangulation, as a mesh whose
/// edges are chords: its faces are well shaped where those of the input are slivers.
///
/// Flips that would join two vertices twice are left out, so every edge is determined by its ends,
/// and so are those that would give a face without area. The vertices, their numbers and the
/// boundary stay. A mesh that is Delaunay already is returned unchanged.
/// \param mesh an oriented manifold with or without boundary
/// \param mollification of the lengths by which edges are flipped, see `mollified_lengths()`; zero:
/// none, and no edge has length zero
/// \param flips receives the ends that each flipped edge had, in their order
Mesh_view simple_delaunay(const Mesh_view& mesh, double mollification = 0,
                          std::vector<std::array<int, 2>>* flips = nullptr);

/// \brief Likewise, Delaunay by its own edges: chords are shorter than what they stand for in the
/// intrinsic triangulation, so it is flipped again until nothing changes (mostly two or three
/// times).
Mesh_view delaunay_by_chords(Mesh_view mesh, double mollification,
                             std::vector<std::array<int, 2>>& flips);

/// \brief The mesh with vertices moved until all faces have an area, for algorithms on chords.
///
/// A face is thin if its longest edge is not shorter than the sum of the two others by at least
/// `share` of it. Its tips, those opposite to long edges, move along the surface, towards the mean
/// of their neighbours, by the root of `share` of the way: `mollified_lengths()` gives triangles of
/// three collinear points such a height. All other vertices stay to the bit.
///
/// Faces remain thin where whole neighbourhoods lie on a line or in a point.
/// \param share positive
Mesh_view with_opened_faces(const Mesh_view& mesh, double share);

}  // namespace Conformal_geometry_processing::internal
