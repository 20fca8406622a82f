// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

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
