// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/overlaps.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// \brief The distortion of a map to the plane. Faces whose images have no area, because the map
/// shrinks them below the resolution of the numbers, have no angles either: they are counted apart.
struct Flat_distortion {
  int collapsed = 0;                                    ///< faces whose images have no area
  CGP::Conformality map;                                ///< of the others
  CGP::internal::Distribution uniform_quasi_conformal;  ///< of the others, by their number
  CGP::internal::Overlap_summary overlap;
};

/// \param positions 3 x |V| in units of the mesh, with z = 0
Flat_distortion flat_distortion(const CGP::Mesh_view& mesh, const CGP::Points& positions);

}  // namespace conformal
