// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief a triangle of a surface in the plane of a face of its mesh: the domain of integration of
/// every operator, see `ConformalSurface`.
///
/// Functions on the vertices are linear on the triangle; the tangent plane is that of the face. A
/// triangle that passes through several faces has one sheet in each, with the share of its area
/// that lies in the face.
struct Sheet {
  std::array<int, 3> corners;  ///< vertices, counter-clockwise; one may occur twice
  std::array<int, 3> edges;    ///< the edge opposite each corner, -1 if it has no number
  int triangle;                ///< of the surface; sheets are ordered by it
  int face;                    ///< of the mesh
  double area;                 ///< of the triangle
  double share;                ///< of the area that lies in the face; the shares of a triangle add
                               ///< up to 1
  Eigen::Matrix3d vectors;     ///< column c: from corner c + 1 to corner c + 2, in the face's plane
};

}  // namespace Conformal_geometry_processing
