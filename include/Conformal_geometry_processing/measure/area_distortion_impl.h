// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_AREA_DISTORTION_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_AREA_DISTORTION_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/area_distortion.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::VectorXd length_scales(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd scale(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    scale[f] =
        std::sqrt(mesh.double_area_vector(f, positions).norm() / mesh.double_area_vector(f).norm());
  return scale;
}

namespace internal {

CGP_INLINE double collapsed_share(const Eigen::VectorXd& scale, const Eigen::VectorXd& areas)
{
  const Eigen::VectorXd new_areas = areas.cwiseProduct(scale.cwiseAbs2());
  const double usual = std::sqrt(new_areas.sum() / areas.sum());
  const auto shrank = scale.array() < usual / 10;
  const auto grew = scale.array() > usual * 10;
  return (std::max)(shrank.select(areas.array(), 0).sum() / areas.sum(),
                    grew.select(new_areas.array(), 0).sum() / new_areas.sum());
}

}  // namespace internal

CGP_INLINE internal::Area_distortion area_distortion(const Mesh_view& mesh, const Points& positions)
{
  const Eigen::VectorXd scale = length_scales(mesh, positions), areas = face_areas(mesh);
  const Eigen::VectorXd u = scale.array().log();
  const double mean = areas.dot(u) / areas.sum();
  const double variance = areas.dot((u.array() - mean).square().matrix()) / areas.sum();
  return {scale.minCoeff(), scale.maxCoeff(), std::sqrt(variance),
          internal::collapsed_share(scale, areas)};
}

}  // namespace Conformal_geometry_processing

#endif
