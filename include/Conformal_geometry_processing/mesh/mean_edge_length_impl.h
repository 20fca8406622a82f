// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_MEAN_EDGE_LENGTH_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_MEAN_EDGE_LENGTH_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>

namespace Conformal_geometry_processing {

CGP_INLINE double mean_edge_length(const Surface_ref& surface)
{
  double sum = 0;
  for (int k = 0; k < surface.size_of_edges(); ++k)
    sum += (surface.position(surface.ends(k)[1]) - surface.position(surface.ends(k)[0])).norm();
  return sum / surface.size_of_edges();
}

}  // namespace Conformal_geometry_processing

#endif
