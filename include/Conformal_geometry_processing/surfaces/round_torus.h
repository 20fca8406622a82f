// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_ROUND_TORUS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_ROUND_TORUS_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/surfaces/stereographic_projection.h>
#include <Conformal_geometry_processing/surfaces/torus_grid.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief the torus of revolution about the axis z whose tube of radius r is at the distance R from
/// the axis; normals point outward.
///
/// It is the image of a product of two circles in the 3-sphere, and the vertices are at equal
/// steps along both: its faces are near halves of one rectangle, large outside and small inside.
/// Conformally it is the rectangle of sides 1 and b = sqrt((R/r)^2 - 1), its Willmore energy is
/// pi^2 (b + 1/b), and for b from 1/sqrt(3) to sqrt(3) no torus of that class is known that has
/// less [CGP 6.5.4].
/// \param m, n how many vertices go around the axis, and around the tube
/// \throw Precondition_error unless R > r > 0, and m and n are at least three
inline Mesh_view round_torus(double R, double r, int m, int n)
{
  if (!(R > r && r > 0 && std::isfinite(R)))
    throw Precondition_error("round_torus", "the radii are " + std::to_string(R) + " and " +
                                                std::to_string(r) + ", wanted R > r > 0");
  const double s = r / R, c = std::sqrt((1 - s) * (1 + s)), turn = 2 * std::acos(-1.);
  return torus_grid(m, n, 0, [&](int i, int j) -> Eigen::Vector3d {
    const double u = turn * i / m, v = turn * j / n;
    return R * c *
           stereographic_projection(
               {s * std::cos(v), c * std::cos(u), c * std::sin(u), s * std::sin(v)});
  });
}

/// \ingroup PkgSurfaces
/// \brief the homogeneous torus of modulus i b: the round one with r = 1 and R = sqrt(1 + b^2), in
/// nearly square pairs of faces; b = 1 is the Clifford torus, of energy 2 pi^2.
/// \param n how many vertices go around the tube; b n, rounded, go around the axis
/// \throw Precondition_error unless b is positive, and n and b n are at least three
inline Mesh_view homogeneous_torus(double b, int n)
{
  if (!(b > 0) || !(b * n < 1e6))
    throw Precondition_error("homogeneous_torus",
                             "the modulus is " + std::to_string(b) + " i, wanted b positive");
  return round_torus(std::sqrt(1 + b * b), 1, static_cast<int>(std::round(b * n)), n);
}

}  // namespace Conformal_geometry_processing

#endif
