// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Flow_report_io.h>

#include <Conformal_geometry_processing/measure/Conformality.h>

#include <ostream>

namespace Conformal_geometry_processing {
namespace internal {

/// the first reason why a flow is no success, as its conversion to `bool` judges
const char* fault_of(const Flow_report& r)
{
  const Conformality::Fault map = r.conformality.fault({});
  if (!r.is_complete()) return to_string(r.stop);
  if (map != Conformality::Fault::none) return to_string(map);
  return r.keeps_conformal_type() ? "none" : "the conformal type has changed";
}

}  // namespace internal

std::ostream& operator<<(std::ostream& out, const Flow_report& r)
{
  out << "steps                  " << r.steps.size() << "; " << to_string(r.stop)
      << "\nenergy                 from " << r.initial_energy << " to " << r.energy << '\n';
  if (!r.message.empty()) out << "last trial             rejected: " << r.message << '\n';
  internal::print_conformality(out, r.conformality);
  return out << "conformal type         changed by " << r.conformal_type_change
             << ", period defect " << r.period_defect << "\nfault                  "
             << internal::fault_of(r) << '\n';
}

}  // namespace Conformal_geometry_processing
