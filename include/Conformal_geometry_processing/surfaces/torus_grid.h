// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <cstddef>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief Creates a torus as a grid of m x n vertices and 2 m n faces, with vertex i n + j at
/// `point(i, j)`; row m is row 0 shifted by `shift` columns.
///
/// The diagonals run from (i, j) to (i + 1, j + 1). The faces are counter-clockwise if j points
/// upwards and i to the right. If `point` is conformal, and its grid consists of squares, the
/// modulus is that of the lattice of i and (m - i shift) / n, up to SL(2, Z).
/// \param m, n at least three
/// \param shift any integer
/// \param point returns a position for 0 <= i < m, 0 <= j < n; the caller ensures that
/// (m, j) would be (0, j + shift)
/// \throw Precondition_error if there are fewer rows or columns
template <class Point>
Mesh_view torus_grid(int m, int n, int shift, Point point)
{
  if (m < 3 || n < 3)
    throw Precondition_error("torus_grid", "the grid is " + std::to_string(m) + " x " +
                                               std::to_string(n) +
                                               ", wanted three at least each way");
  const int step = (shift % n + n) % n;
  const auto number = [&](int i, int j) { return i % m * n + (j + (i == m ? step : 0)) % n; };
  Points p(3, m * n);
  Mesh_view::Corners corners;
  corners.reserve(static_cast<std::size_t>(2 * m * n));
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      p.col(i * n + j) = point(i, j);
      corners.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      corners.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return {std::move(p), std::move(corners)};
}

}  // namespace Conformal_geometry_processing
