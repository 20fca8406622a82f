// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_MASS_MATRICES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_MASS_MATRICES_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <cstddef>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::VectorXd face_areas(const Mesh_view& mesh)
{
  Eigen::VectorXd areas(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) areas[f] = mesh.double_area_vector(f).norm() / 2;
  return areas;
}

CGP_INLINE Eigen::VectorXd vertex_areas(const Mesh_view& mesh)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) areas[v] += mesh.double_area_vector(f).norm() / 6;
  return areas;
}

CGP_INLINE Eigen::VectorXd voronoi_areas(const Mesh_view& mesh)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double double_area = mesh.double_area_vector(f).norm();
    Eigen::Vector3d squared, inner;  // |e_c|^2, and <edge, edge> at corner c, negative if obtuse
    for (int c = 0; c < 3; ++c) {
      squared[c] = mesh.vector(3 * f + c).squaredNorm();
      inner[c] = -mesh.vector(3 * f + (c + 1) % 3).dot(mesh.vector(3 * f + (c + 2) % 3));
    }
    const bool is_obtuse = inner.minCoeff() < 0;
    for (int c = 0; c < 3; ++c) {
      const int a = (c + 1) % 3, b = (c + 2) % 3;
      areas[mesh.corners(f)[static_cast<std::size_t>(c)]] +=
          is_obtuse ? double_area / (inner[c] < 0 ? 4 : 8)
                    : (squared[a] * inner[a] + squared[b] * inner[b]) / (8 * double_area);
    }
  }
  return areas;
}

}  // namespace Conformal_geometry_processing

#endif
