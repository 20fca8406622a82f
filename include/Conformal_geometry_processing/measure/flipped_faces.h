// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_FLIPPED_FACES_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_FLIPPED_FACES_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <cstddef>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief what the normals of the faces should be if the surface does not fold: the sum of the
/// area-weighted normals of their corners; 3 x |F|, not of unit length.
inline Points neighbourhood_normals(const Mesh_view& mesh)
{
  const Points at_vertices = vertex_normals(mesh, Normal_weight::area);
  Points normals(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    normals.col(f) = at_vertices.col(v[0]) + at_vertices.col(v[1]) + at_vertices.col(v[2]);
  }
  return normals;
}

/// \ingroup PkgMeasure
/// \brief what the normals of the faces should be if a deformation folds nothing and unfolds
/// nothing: the neighbourhood normals of the new surface, reversed where a face was against its
/// neighbourhood before; 3 x |F|, not of unit length.
///
/// Where a face stood upright on its neighbourhood, or had none (area zero, faces that cancel out),
/// nothing can be told: there it is the new normal itself.
/// \param positions the new ones, 3 x |V|
inline Points neighbourhood_normals(const Mesh_view& before, const Points& positions)
{
  Mesh_view after = before;
  after.set_positions(positions);
  const Points old_normals = neighbourhood_normals(before);
  Points normals = neighbourhood_normals(after);
  for (int f = 0; f < before.size_of_faces(); ++f) {
    const double side = before.double_area_vector(f).dot(old_normals.col(f));
    if (side < 0) normals.col(f) *= -1;
    if (side == 0) normals.col(f) = after.double_area_vector(f);
  }
  return normals;
}

/// \ingroup PkgMeasure
/// the number of faces whose new normal makes an obtuse angle with the one expected, or that have
/// area zero
/// \param positions the new ones, 3 x |V|
/// \param expected 3 x |F|, for instance the old normals rotated by the spins of the faces
inline int flipped_faces(const Mesh_view& mesh, const Points& positions, const Points& expected)
{
  int count = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    count += !(mesh.double_area_vector(f, positions).dot(expected.col(f)) > 0);
  return count;
}

}  // namespace Conformal_geometry_processing

#endif
