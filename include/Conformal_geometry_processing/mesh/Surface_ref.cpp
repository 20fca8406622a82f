// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

namespace Conformal_geometry_processing {

double mean_edge_length(const Surface_ref& surface)
{
  double sum = 0;
  for (int k = 0; k < surface.size_of_edges(); ++k)
    sum += (surface.position(surface.ends(k)[1]) - surface.position(surface.ends(k)[0])).norm();
  return sum / surface.size_of_edges();
}

}  // namespace Conformal_geometry_processing
