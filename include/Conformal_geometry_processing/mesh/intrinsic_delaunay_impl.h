// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_INTRINSIC_DELAUNAY_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_INTRINSIC_DELAUNAY_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/intrinsic_delaunay.h>

#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE bool is_delaunay(const internal::Intrinsic_triangulation& triangles, int h)
{
  const double pi = std::acos(-1.), tolerance = 1e-10;
  const int t = triangles.twin(h);
  // Written so that what is not a number is never flipped.
  return t < 0 || !(triangles.angle(h) + triangles.angle(t) > pi + tolerance);
}

CGP_INLINE int flip_to_delaunay(internal::Intrinsic_triangulation& triangles)
{
  return flip_to_delaunay(triangles, [](int) {});
}

}  // namespace Conformal_geometry_processing

#endif
