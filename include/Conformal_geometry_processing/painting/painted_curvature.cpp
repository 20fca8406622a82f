// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/painting/painted_curvature.h>

namespace Conformal_geometry_processing {

Curvature_potential painted_curvature(const Gray_image& image, const Eigen::Matrix2Xd& places,
                                      double amplitude)
{
  return Curvature_potential::on_faces(amplitude * (image(places).array() - 0.5));
}

}  // namespace Conformal_geometry_processing
