// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <utility>

#include "support/random.h"

/// Surfaces with boundary. Flat ones lie in the plane z = 0 with normals +z.
namespace cgp_test {

/// (0, 0), (2, 0), (0, 1): area 1, the triangle whose matrices the specification tables
Mesh_view single_triangle();

/// two triangles along the diagonal (0, 0)-(1, 1)
Mesh_view unit_square();

/// two triangles for the square between (i, j) and (i + 1, j + 1), diagonals alternating
void add_square(Corners& corners, int i, int j, int v00, int v10, int v11, int v01);

/// the rectangle [0, a] x [0, b] in nx x ny squares; vertex i + (nx + 1) j
Mesh_view grid(int nx, int ny, double a = 1, double b = 1);

/// a ring of m squares around the z axis (m even) and n across; vertex j m + i is point(angle, s)
/// with s = j/n in [0, 1]. The normal is d point / d angle x d point / d s.
template <class Point>
Mesh_view ring(int m, int n, Point point)
{
  Points p(3, m * (n + 1));
  Corners corners;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i < m; ++i) {
      p.col(j * m + i) = point(2 * pi * i / m, double(j) / n);
      const int k = (i + 1) % m;
      if (j < n) add_square(corners, i, j, j * m + i, j * m + k, (j + 1) * m + k, (j + 1) * m + i);
    }
  return {std::move(p), std::move(corners)};
}

/// around the z axis, z in [0, height], normals outward
Mesh_view cylinder(double radius, double height, int m, int n);

/// the plane annulus between two circles; the outer one is s = 0
Mesh_view annulus(double inner, double outer, int m, int n);

/// the concentric unit disk of the specification: ring k has 6k vertices, F = 6 n^2
Mesh_view disk(int n);

/// the unit disk with faces that grow towards x = -1: `disk(n)` moved by z -> (z + .4)/(1 + .4 z)
Mesh_view moved_disk(int n);

/// `disk(n)` with every vertex moved in the plane by up to the share `amount` of an edge, on the
/// boundary along the circle
Mesh_view jittered_disk(int n, double amount, std::uint64_t seed = 1);

/// the conformal (stereographic) image of a plane disk: the spherical cap of polar angle alpha
/// around +z, normals outward
Mesh_view cap_from_disk(const Mesh_view& disk, double alpha);

}  // namespace cgp_test
