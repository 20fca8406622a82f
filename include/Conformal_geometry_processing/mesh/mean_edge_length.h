// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_MEAN_EDGE_LENGTH_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_MEAN_EDGE_LENGTH_H

#include <Conformal_geometry_processing/mesh/Surface_ref.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// the mean length h of the edges
/// \pre there is an edge
double mean_edge_length(const Surface_ref& surface);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/mean_edge_length_impl.h>
#endif

#endif
