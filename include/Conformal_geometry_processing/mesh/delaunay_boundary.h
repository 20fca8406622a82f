// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_BOUNDARY_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_BOUNDARY_H

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <Eigen/Core>

#include <vector>

/// \file delaunay_boundary.h
/// \brief the boundary of a `Delaunay_view`: `boundary_loops.h` and `Boundary_frames.h` where faces
/// may have area zero.
namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// those of the mesh
std::vector<std::vector<int>> boundary_loops(const Delaunay_view& mesh);

/// \ingroup PkgMesh
/// the mean length h of the edges of the triangulation, straight
double mean_edge_length(const Delaunay_view& mesh);

/// \ingroup PkgMesh
/// \brief the unit normals of the vertices, weighted by the angles of the triangles and by the
/// shares of their sheets, 3 x |V|.
Points vertex_normals(const Delaunay_view& mesh);

/// \ingroup PkgMesh
/// the frames of all boundary vertices
Boundary_frames boundary_frames(const Delaunay_view& mesh);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/delaunay_boundary_impl.h>
#endif

#endif
