// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief Finds the cap triangles at the boundary, whose angle opposite a boundary edge exceeds 150
/// degrees, and those that become caps after removal of other ones.
///
/// Flips cannot remove them, and the gradient of a linear function on a cap is the difference
/// between its corner and the middle of the boundary edge, divided by the small height of the cap.
/// `Delaunay_view` therefore uses functions that are constant along that height, with a kink at its
/// foot.
/// \returns for each triangle the halfedge opposite that angle, or -1
std::vector<int> boundary_caps(const internal::Intrinsic_triangulation& triangles);

}  // namespace Conformal_geometry_processing
