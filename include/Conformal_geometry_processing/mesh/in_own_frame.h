// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
/// \brief Returns the mesh in its `Normalized_frame`: of moderate size, where products of areas and
/// volumes neither overflow nor underflow.
/// \pre the mesh has vertices, with finite coordinates
Mesh_view in_own_frame(Mesh_view mesh);

}  // namespace Conformal_geometry_processing::internal
