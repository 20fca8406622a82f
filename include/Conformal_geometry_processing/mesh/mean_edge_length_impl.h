// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_MEAN_EDGE_LENGTH_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_MEAN_EDGE_LENGTH_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>

namespace Conformal_geometry_processing {

CGP_INLINE double mean_edge_length(const Mesh_view& mesh)
{
  double sum = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    sum += (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).norm();
  return sum / mesh.size_of_edges();
}

}  // namespace Conformal_geometry_processing

#endif
