// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Conformality_io.h>

#include <ostream>

namespace Conformal_geometry_processing::internal {

void print_conformality(std::ostream& out, const Conformality& c)
{
  out << "quasi-conformal error  " << c.quasi_conformal.mean << " mean, " << c.quasi_conformal.p99
      << " for 99 %, " << c.quasi_conformal.max << " at most (1 is conformal)\n"
      << "length cross-ratios    changed by " << c.length_cross_ratio.rms << " rms, "
      << c.length_cross_ratio.max << " at most (0 is conformal)\n"
      << "lengths                scaled by " << c.scale.min_scale << " to " << c.scale.max_scale
      << "\nflipped faces          " << c.flipped_faces << '\n';
}

}  // namespace Conformal_geometry_processing::internal
