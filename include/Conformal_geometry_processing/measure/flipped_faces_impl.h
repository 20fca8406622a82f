// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_FLIPPED_FACES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_FLIPPED_FACES_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/flipped_faces.h>
#include <Conformal_geometry_processing/mesh/normals.h>

namespace Conformal_geometry_processing {

CGP_INLINE Points neighbourhood_normals(const Mesh_view& mesh)
{
  const Points at_vertices = vertex_normals(mesh, internal::Normal_weight::area);
  Points normals(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    normals.col(f) = at_vertices.col(v[0]) + at_vertices.col(v[1]) + at_vertices.col(v[2]);
  }
  return normals;
}

CGP_INLINE Points neighbourhood_normals(const Mesh_view& before, const Points& positions)
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

CGP_INLINE int flipped_faces(const Mesh_view& mesh, const Points& positions, const Points& expected)
{
  int count = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    count += !(mesh.double_area_vector(f, positions).dot(expected.col(f)) > 0);
  return count;
}

}  // namespace Conformal_geometry_processing

#endif
