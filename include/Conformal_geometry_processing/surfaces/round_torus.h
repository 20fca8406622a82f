// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

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

/// \ingroup PkgSurfaces
/// \brief Returns the stereographic projection of a point of the 3-sphere, a unit quaternion q:
/// Im q / (1 - Re q), a conformal map; 1 is mapped to infinity, -1 to the origin.
///
/// To project from another point p, multiply by its conjugate: conjugate(p) q. All these images of
/// a surface are Moebius transforms of each other.
/// \pre q has unit length and is not 1
Eigen::Vector3d stereographic_projection(const Quaternion<double>& q);

/// \ingroup PkgSurfaces
/// \brief Creates the torus of revolution about the axis z whose tube of radius r has the distance
/// R from the axis; normals point outward.
///
/// It is the image of a product of two circles in the 3-sphere, with vertices at equal steps along
/// both: its faces are, up to discretization, conformal to halves of one rectangle, large outside
/// and small inside. The torus is conformal to the rectangle of sides 1 and b = sqrt((R/r)^2 - 1),
/// its Willmore energy is pi^2 (b + 1/b), and for b from 1/sqrt(3) to sqrt(3) no torus with less
/// energy is known in its conformal class [CGP 6.5.4].
/// \param m, n number of vertices around the axis, and around the tube
/// \throw Precondition_error unless R > r > 0, and m and n are at least three
Mesh_view round_torus(double R, double r, int m, int n);

/// \ingroup PkgSurfaces
/// \brief Creates the homogeneous torus of modulus i b: the round one with r = 1 and
/// R = sqrt(1 + b^2), in nearly square pairs of faces; b = 1 is the Clifford torus, of energy
/// 2 pi^2.
/// \param n number of vertices around the tube; b n, rounded, are around the axis
/// \throw Precondition_error unless b is positive, and n and b n are at least three
Mesh_view homogeneous_torus(double b, int n);

}  // namespace Conformal_geometry_processing
