// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
/// \brief The mesh with the connectivity of its intrinsic Delaunay triangulation, as a mesh whose
/// edges are chords: its faces are well shaped where those of the input are slivers.
///
/// Flips that would join two vertices twice are left out, so every edge is determined by its ends,
/// and so are those that would give a face without area. The vertices, their numbers and the
/// boundary stay. A mesh that is Delaunay already is returned unchanged.
/// \param mesh an oriented manifold with or without boundary
/// \param mollification of the lengths by which edges are flipped, see `mollified_lengths()`; zero:
/// none, and no edge has length zero
Mesh_view simple_delaunay(const Mesh_view& mesh, double mollification = 0);

/// \ingroup PkgMesh
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
