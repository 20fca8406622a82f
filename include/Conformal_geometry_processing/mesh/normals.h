// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

namespace Conformal_geometry_processing {
namespace internal {

/// the weight of each incident face in the normal of a vertex
enum class Normal_weight {
  area,    ///< its area: the sum is the gradient of the enclosed volume
  angle,   ///< its angle at the vertex: independent of the triangulation of flat regions
  uniform  ///< 1
};

}  // namespace internal

/// \ingroup PkgMesh
/// the unit normals of the faces, 3 x |F|, outward on a counter-clockwise oriented surface
/// \pre no face has area zero
Points face_normals(const Mesh_view& mesh);

/// \ingroup PkgMesh
/// the angle of a sheet's triangle at corner c, in (0, pi)
double corner_angle(const Sheet& sheet, int c);

/// \ingroup PkgMesh
/// the unit normals of the vertices, 3 x |V|; zero where the faces around a vertex cancel out
Points vertex_normals(const Surface_ref& surface,
                      internal::Normal_weight weight = internal::Normal_weight::area);

}  // namespace Conformal_geometry_processing
