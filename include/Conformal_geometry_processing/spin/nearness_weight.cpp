// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/nearness_weight.h>

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <cmath>

namespace Conformal_geometry_processing {

double nearness_weight(const Surface_ref& surface)
{
  const double pi = std::acos(-1.);
  const double alpha = 10 * mean_edge_length(surface) / (vertex_areas(surface).sum() / pi);
  return alpha * alpha;
}

}  // namespace Conformal_geometry_processing
