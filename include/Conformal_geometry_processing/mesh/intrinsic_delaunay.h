// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>

#include <deque>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief Returns whether the sum of the angles opposite the edge of h is at most pi, so that its
/// cotan weight is not negative; true for boundary edges.
///
/// Tolerates an excess of 1e-10, to avoid infinite flipping due to rounding.
bool is_delaunay(const internal::Intrinsic_triangulation& triangles, int h);

/// \ingroup PkgMesh
/// \brief Flips edges until all are Delaunay [Bobenko and Springborn 2007]. Every flip reduces the
/// Dirichlet energy of piecewise linear functions, down to the minimum over all triangulations.
///
/// \param may_flip called with a halfedge of each edge that is not Delaunay; left as it is if false
/// \param before_flip called with a halfedge of each edge before it is flipped
/// \returns the number of flips; usually a few per badly shaped triangle
template <class MayFlip, class BeforeFlip>
int flip_to_delaunay(internal::Intrinsic_triangulation& triangles, MayFlip may_flip,
                     BeforeFlip before_flip)
{
  std::deque<int> waiting;
  for (int h = 0; h < triangles.size_of_halfedges(); ++h)
    if (h < triangles.twin(h)) waiting.push_back(h);
  int flips = 0;
  while (!waiting.empty()) {
    const int h = waiting.front(), t = triangles.twin(h);
    waiting.pop_front();
    // If both sides of an edge are the same face, the sum of the two angles is less than pi.
    if (t < 0 || h / 3 == t / 3 || is_delaunay(triangles, h) || !may_flip(h)) continue;
    before_flip(h);
    triangles.flip(h);
    ++flips;
    for (const int face : {h / 3, t / 3})
      for (const int side : {0, 2}) waiting.push_back(3 * face + side);  // 1 is the new edge
  }
  return flips;
}

/// \ingroup PkgMesh
/// Flips all edges that are not Delaunay
template <class BeforeFlip>
int flip_to_delaunay(internal::Intrinsic_triangulation& triangles, BeforeFlip before_flip)
{
  return flip_to_delaunay(
      triangles, [](int) { return true; }, before_flip);
}

/// \ingroup PkgMesh
/// Flips edges likewise, without a callback
int flip_to_delaunay(internal::Intrinsic_triangulation& triangles);

}  // namespace Conformal_geometry_processing
