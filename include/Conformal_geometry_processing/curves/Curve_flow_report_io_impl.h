// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FLOW_REPORT_IO_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FLOW_REPORT_IO_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/curves/Curve_flow_report_io.h>

#include <ostream>

namespace Conformal_geometry_processing {

CGP_INLINE std::ostream& operator<<(std::ostream& out, const Curve_flow_report& r)
{
  return out << "steps                  " << r.steps.size() << "; " << to_string(r.stop)
             << "\nbending energy         from " << r.initial_energy << " to " << r.energy
             << "\nlength                 " << r.length << ", of edges changed by "
             << r.length_distortion << " at most\nfault                  "
             << (r ? "none" : to_string(r.stop)) << '\n';
}

}  // namespace Conformal_geometry_processing

#endif
