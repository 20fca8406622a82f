// Tests include/Conformal_geometry_processing/flow/Flow_report.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Flow_report.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace cgp_test::flow_report_tests {

using Conformal_geometry_processing::Flow_report;
using Flow_stop = Conformal_geometry_processing::Flow_step_report::Stop;

constexpr Flow_stop all[] = {
    Flow_stop::none,           Flow_stop::energy_settled, Flow_stop::direction_vanished,
    Flow_stop::steps_done,     Flow_stop::cancelled,      Flow_stop::time_step_too_small,
    Flow_stop::limits_reached, Flow_stop::scale_range,    Flow_stop::step_failed};

TEST(Flow_report, tells_every_reason_apart)
{
  std::set<std::string> texts;
  for (const Flow_stop stop : all) texts.insert(to_string(stop));
  EXPECT_EQ(texts.size(), std::size(all));
  EXPECT_EQ(texts.count("unknown"), 0U);
  EXPECT_STREQ(to_string(static_cast<Flow_stop>(99)), "unknown");
}

TEST(Flow_report, is_true_for_what_was_asked_for_and_converged_only_at_the_end)
{
  for (const Flow_stop stop : all) {
    Flow_report report;
    report.stop = stop;
    const bool has_arrived =
        stop == Flow_stop::energy_settled || stop == Flow_stop::direction_vanished;
    EXPECT_EQ(report.converged(), has_arrived) << to_string(stop);
    EXPECT_EQ(static_cast<bool>(report), has_arrived || stop == Flow_stop::steps_done)
        << to_string(stop);
  }
}

TEST(Flow_report, is_false_where_the_conformal_type_is_not_kept)
{
  Flow_report report;
  report.stop = Flow_stop::steps_done;
  for (const double defect : {.04, .05}) {
    Conformal_geometry_processing::Flow_step_report step;
    step.accepted = true;
    step.stop = Flow_stop::steps_done;
    step.period_defect = defect;
    EXPECT_TRUE(append(report, step));
    EXPECT_TRUE(report);
  }
  EXPECT_NEAR(report.period_defect, .09, 1e-15);
  report.period_defect = .11;
  EXPECT_FALSE(report);
  report.period_defect = 0;
  report.conformal_type_change = .11;
  EXPECT_FALSE(report);
}

}  // namespace cgp_test::flow_report_tests
