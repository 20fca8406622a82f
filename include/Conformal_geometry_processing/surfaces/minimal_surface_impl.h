// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_MINIMAL_SURFACE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_MINIMAL_SURFACE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE double minimal_kernel_tolerance(const Mesh_view& mesh)
{
  const double pi = std::acos(-1.);
  return boundary_loops(mesh).size() > 1 ? 3 * mean_edge_length(mesh) * pi / face_areas(mesh).sum()
                                         : 0;
}

}  // namespace Conformal_geometry_processing

#endif
