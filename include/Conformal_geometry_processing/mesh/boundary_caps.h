// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_BOUNDARY_CAPS_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_BOUNDARY_CAPS_H

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief the triangles that lie along the boundary like a cap, with an angle of more than 150
/// degrees opposite to it, and those that do so once such ones are taken away.
///
/// No flip gets rid of them, and a function that is linear there has the slope of its corner
/// against the middle of the boundary edge, over the height of the cap. So functions are taken that
/// are constant along that height, and bend at its foot (`Delaunay_view`).
/// \returns for each triangle the halfedge opposite that angle, or -1
std::vector<int> boundary_caps(const Intrinsic_triangulation& triangles);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/boundary_caps_impl.h>
#endif

#endif
