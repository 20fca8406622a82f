// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_CONFORMALITY_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_CONFORMALITY_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/quasi_conformal_error.h>

namespace Conformal_geometry_processing {

CGP_INLINE Conformality conformality(const Mesh_view& mesh, const Points& positions,
                                     const Points& expected_normals)
{
  return {quasi_conformal_error(mesh, positions), length_cross_ratio_change(mesh, positions),
          area_distortion(mesh, positions), flipped_faces(mesh, positions, expected_normals)};
}

}  // namespace Conformal_geometry_processing

#endif
