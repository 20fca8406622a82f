// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_RESTORE_AREA_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_RESTORE_AREA_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/restore_area.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Eigen::Vector3d centroid(const Mesh_view& mesh, const Points& f,
                                    const Eigen::VectorXd& areas)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < mesh.size_of_faces(); ++i)
    for (int v : mesh.corners(i)) sum += areas[i] / 3 * f.col(v);
  return sum / areas.sum();
}

}  // namespace internal

CGP_INLINE void restore_area(const Mesh_view& mesh, Points& f, Quaternion_vector<double>& lambda)
{
  const Eigen::VectorXd areas = face_areas(mesh);
  Eigen::VectorXd new_areas(areas.size());
  for (int i = 0; i < mesh.size_of_faces(); ++i)
    new_areas[i] = mesh.double_area_vector(i, f).norm() / 2;
  const double scale = std::sqrt(areas.sum() / new_areas.sum());
  f *= scale;
  components(lambda) *= std::sqrt(scale);
  f.colwise() +=
      internal::centroid(mesh, mesh.positions(), areas) - internal::centroid(mesh, f, new_areas);
}

}  // namespace Conformal_geometry_processing

#endif
