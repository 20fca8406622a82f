// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// the mean length h of the edges
/// \pre there is an edge
double mean_edge_length(const Surface_ref& surface);

}  // namespace Conformal_geometry_processing
