// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/intrinsic_delaunay.h>

#include <cmath>

namespace Conformal_geometry_processing {

bool is_delaunay(const internal::Intrinsic_triangulation& triangles, int h)
{
  const double pi = std::acos(-1.), tolerance = 1e-10;
  const int t = triangles.twin(h);
  // Written so that what is not a number is never flipped.
  return t < 0 || !(triangles.angle(h) + triangles.angle(t) > pi + tolerance);
}

int flip_to_delaunay(internal::Intrinsic_triangulation& triangles)
{
  return flip_to_delaunay(triangles, [](int) {});
}

}  // namespace Conformal_geometry_processing
