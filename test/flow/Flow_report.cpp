// Tests include/Conformal_geometry_processing/flow/Flow_report.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Flow_report.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {

using Conformal_geometry_processing::Flow_report;
using Flow_stop = Conformal_geometry_processing::Flow_step_report::Stop;

constexpr Flow_stop all[] = {
    Flow_stop::none,       Flow_stop::energy_settled, Flow_stop::direction_vanished,
    Flow_stop::steps_done, Flow_stop::cancelled,      Flow_stop::time_step_too_small,
    Flow_stop::step_failed};

}  // namespace

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
