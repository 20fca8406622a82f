// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PAINTING_PAINTED_CURVATURE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_PAINTING_PAINTED_CURVATURE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/painting/painted_curvature.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE Curvature_potential painted_curvature(const Gray_image& image,
                                                 const Eigen::Matrix2Xd& places, double amplitude)
{
  return Curvature_potential::on_faces(amplitude * (image(places).array() - 0.5));
}

}  // namespace Conformal_geometry_processing

#endif
