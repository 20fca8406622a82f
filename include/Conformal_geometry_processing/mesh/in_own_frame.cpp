// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/in_own_frame.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

namespace Conformal_geometry_processing {

Mesh_view internal::in_own_frame(Mesh_view mesh)
{
  mesh.set_positions(Normalized_frame(mesh.positions()).to_frame(mesh.positions()));
  return mesh;
}

}  // namespace Conformal_geometry_processing
