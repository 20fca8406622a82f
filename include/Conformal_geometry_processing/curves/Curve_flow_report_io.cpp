// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Curve_flow_report_io.h>

#include <ostream>

namespace Conformal_geometry_processing {

std::ostream& operator<<(std::ostream& out, const Curve_flow_report& r)
{
  return out << "steps                  " << r.steps.size() << "; " << to_string(r.stop)
             << "\nbending energy         from " << r.initial_energy << " to " << r.energy
             << "\nlength                 " << r.length << ", of edges changed by "
             << r.length_distortion << " at most\nfault                  "
             << (r ? "none" : to_string(r.stop)) << '\n';
}

}  // namespace Conformal_geometry_processing
