// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_AREA_DISTORTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_AREA_DISTORTION_H

#include <Conformal_geometry_processing/measure/Distribution.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// the factor by which the map scales lengths, sqrt(new area / old area), for each face
/// \param positions the new ones, 3 x |V|
inline Eigen::VectorXd length_scales(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd scale(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    scale[f] =
        std::sqrt(mesh.double_area_vector(f, positions).norm() / mesh.double_area_vector(f).norm());
  return scale;
}

/// \ingroup PkgMeasure
/// how unevenly a map scales a surface
struct Area_distortion {
  double min_scale = 1, max_scale = 1;  ///< range of `length_scales()`
  double log_deviation = 0;  ///< standard deviation of the log of the scale, weighted by area
};

/// \ingroup PkgMeasure
/// the distortion of area from the mesh to the new positions
inline Area_distortion area_distortion(const Mesh_view& mesh, const Points& positions)
{
  const Eigen::VectorXd scale = length_scales(mesh, positions), areas = face_areas(mesh);
  const Eigen::VectorXd u = scale.array().log();
  const double mean = areas.dot(u) / areas.sum();
  const double variance = areas.dot((u.array() - mean).square().matrix()) / areas.sum();
  return {scale.minCoeff(), scale.maxCoeff(), std::sqrt(variance)};
}

}  // namespace Conformal_geometry_processing

#endif
