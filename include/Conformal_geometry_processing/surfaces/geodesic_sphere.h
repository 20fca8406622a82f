// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief Creates the unit sphere with 20 n^2 faces: divides the edges of the icosahedron into n
/// parts and projects the points of its faces. Normals point outward.
/// \param frequency n
/// \throw Precondition_error if it is below one
Mesh_view geodesic_sphere(int frequency);

}  // namespace Conformal_geometry_processing
