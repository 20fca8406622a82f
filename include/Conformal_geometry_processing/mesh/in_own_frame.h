// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_IN_OWN_FRAME_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_IN_OWN_FRAME_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgMesh
/// \brief Returns the mesh in its `Normalized_frame`: of moderate size, where products of areas and
/// volumes neither overflow nor underflow.
/// \pre the mesh has vertices, with finite coordinates
Mesh_view in_own_frame(Mesh_view mesh);

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/in_own_frame_impl.h>
#endif

#endif
