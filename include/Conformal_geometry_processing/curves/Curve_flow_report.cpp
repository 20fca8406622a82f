// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Curve_flow_report.h>

#include <ostream>

namespace Conformal_geometry_processing {

const char* to_string(Curve_step_report::Stop stop)
{
  switch (stop) {
    case Curve_step_report::Stop::none:
      return "not stopped";
    case Curve_step_report::Stop::energy_settled:
      return "the energy has settled";
    case Curve_step_report::Stop::steps_done:
      return "all steps are done";
    case Curve_step_report::Stop::cancelled:
      return "cancelled";
    case Curve_step_report::Stop::step_failed:
      return "the step failed";
  }
  return "unknown";
}

bool append(Curve_flow_report& report, const Curve_step_report& step)
{
  report.stop = step.stop;
  if (step.accepted) report.steps.push_back(step);
  return step.accepted;
}

std::ostream& operator<<(std::ostream& out, const Curve_flow_report& r)
{
  return out << "steps                  " << r.steps.size() << "; " << to_string(r.stop)
             << "\nbending energy         from " << r.initial_energy << " to " << r.energy
             << "\nlength                 " << r.length << ", of edges changed by "
             << r.length_distortion << " at most\nfault                  "
             << (r ? "none" : to_string(r.stop)) << '\n';
}

}  // namespace Conformal_geometry_processing
