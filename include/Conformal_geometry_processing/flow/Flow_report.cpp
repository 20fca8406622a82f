// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Flow_report.h>

#include <ostream>
#include <sstream>
#include <utility>

namespace Conformal_geometry_processing {

const char* to_string(Flow_step_report::Stop stop)
{
  switch (stop) {
    case Flow_step_report::Stop::none:
      return "not stopped";
    case Flow_step_report::Stop::energy_settled:
      return "the energy has settled";
    case Flow_step_report::Stop::direction_vanished:
      return "nothing is left of the direction";
    case Flow_step_report::Stop::steps_done:
      return "all steps are done";
    case Flow_step_report::Stop::cancelled:
      return "cancelled";
    case Flow_step_report::Stop::time_step_too_small:
      return "the time step became too small";
    case Flow_step_report::Stop::limits_reached:
      return "the limits of distortion are reached";
    case Flow_step_report::Stop::scale_range:
      return "limbs would shrink beyond double precision";
    case Flow_step_report::Stop::step_failed:
      return "the step failed";
  }
  return "unknown";
}

std::string to_string(const Flow_step_report::Place& place)
{
  if (place.vertex < 0) return {};
  const double degree = 3.14159265358979323846 / 180;
  std::ostringstream text;
  text.precision(2);
  text << ", most at vertex " << place.vertex << ", where face " << place.face
       << " has an angle of " << place.angle / degree << " degrees";
  return text.str();
}

bool Flow_report::converged() const
{
  return stop == Flow_step_report::Stop::energy_settled ||
         stop == Flow_step_report::Stop::direction_vanished;
}

bool append(Flow_report& report, Flow_step_report step)
{
  report.stop = step.stop;
  report.message = step.message;
  report.place = step.place;
  const bool is_accepted = step.accepted;
  if (step.direction_norm_after > 0)
    report.direction_norm = is_accepted ? step.direction_norm_after : step.direction_norm;
  if (is_accepted) report.bounded_steps += step.is_bounded;
  if (is_accepted) report.period_defect += step.period_defect;
  if (is_accepted) report.steps.push_back(std::move(step));
  return is_accepted;
}

namespace internal {

/// the first reason why a flow is not a success, as its conversion to `bool` judges
const char* fault_of(const Flow_report& r)
{
  if (!r.has_volume()) return "the prescribed volume is not reached";
  if (!r.is_complete()) return to_string(r.stop);
  if (r.map_fault() != Conformality::Fault::none) return to_string(r.map_fault());
  return r.keeps_conformal_type() ? "none" : "the conformal type has changed";
}

}  // namespace internal

std::ostream& operator<<(std::ostream& out, const Flow_report& r)
{
  out << "steps                  " << r.steps.size() << "; " << to_string(r.stop)
      << "\nenergy                 from " << r.initial_energy_of_faces << " to "
      << r.energy_of_faces << '\n';
  if (!r.message.empty())
    out << "last trial             rejected: " << r.message << to_string(r.place) << '\n';
  if (r.enclosure.area > 0)
    out << "reduced volume         from " << r.initial_enclosure.reduced_volume << " to "
        << r.enclosure.reduced_volume << '\n';
  internal::print_conformality(out, r.conformality_of_faces);
  return out << "conformal type         changed by " << r.conformal_type_change
             << ", period defect " << r.period_defect << "\nfault                  "
             << internal::fault_of(r) << '\n';
}

}  // namespace Conformal_geometry_processing
