// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_CONFORMALITY_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_CONFORMALITY_H

#include <Conformal_geometry_processing/measure/Distribution.h>
#include <Conformal_geometry_processing/measure/area_distortion.h>
#include <Conformal_geometry_processing/measure/flipped_faces.h>
#include <Conformal_geometry_processing/measure/length_cross_ratio.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief Measures of conformality of the map between two surfaces of the same connectivity, part
/// of the report of every transformation of the library.
struct Conformality {
  internal::Distribution quasi_conformal;  ///< of Q >= 1 over the area
  internal::Length_cross_ratio_change length_cross_ratio;
  internal::Area_distortion scale;  ///< of lengths
  int flipped_faces = 0;
};

/// \ingroup PkgMeasure
/// \param positions the new ones, 3 x |V|
/// \param expected_normals 3 x |F|, to detect flipped faces (`flipped_faces()`)
Conformality conformality(const Mesh_view& mesh, const Points& positions,
                          const Points& expected_normals);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/measure/Conformality_impl.h>
#endif

#endif
