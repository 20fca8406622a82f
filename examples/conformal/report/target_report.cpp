// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "target_report.h"

#include "conformal/process/text.h"

namespace conformal {

void tell_targets(const CGP::Spin_report& spin, std::size_t count, Report& report)
{
  report.tell("result/targets/count", "control points", static_cast<int>(count));
  report.set("result/targets/reached", spin.reached);
  report.show("reached of the way to them (%)", text_of(100 * spin.reached, 3));
  report.set("result/targets/distance/mean", spin.position_error.mean);
  report.tell("result/targets/distance/max", "distance from the targets, max",
              spin.position_error.max, 3);
  report.end_table();
}

void tell_collar(const CGP::Conformality& collar, Report& report)
{
  report.tell("result/collar/quasi_conformal/mean", "quasi-conformal error of the collar, mean",
              collar.quasi_conformal.mean);
  report.tell("result/collar/quasi_conformal/max", "quasi-conformal error of the collar, max",
              collar.quasi_conformal.max);
  report.end_table();
}

std::string fault_of_targets(const CGP::Spin_report& spin, const CGP::Spin_report::Limits& limits)
{
  if (spin.cancelled || spin.reached >= limits.realised_share) return "";
  return "only " + text_of(100 * spin.reached, 3) +
         " % of the way to the targets lead to a surface that verifies; try: nearer targets, a "
         "finer mesh, --weight 30, or --limit realised_share";
}

}  // namespace conformal
