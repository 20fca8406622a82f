// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/distortion.h>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgConformalClass
/// \brief The numbers that verify `snap_to_conformal_class()`.
struct [[nodiscard]] Class_snap_report {
  bool converged = false;
  int iterations = 0, factorizations = 0;
  /// changes of log length cross-ratios from the reference, in the end of the positions as written
  Length_cross_ratio_change initial_length_cross_ratio, length_cross_ratio;
  double displacement = 0;  ///< root mean square over the vertices, by the diagonal of the mesh

  /// whether the surface is in the class; if not, nothing was written
  explicit operator bool() const { return converged; }
};

}  // namespace Conformal_geometry_processing::internal
