// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_IN_OWN_FRAME_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_IN_OWN_FRAME_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/in_own_frame.h>

namespace Conformal_geometry_processing {

CGP_INLINE Mesh_view internal::in_own_frame(Mesh_view mesh)
{
  mesh.set_positions(Normalized_frame(mesh.positions()).to_frame(mesh.positions()));
  return mesh;
}

}  // namespace Conformal_geometry_processing

#endif
