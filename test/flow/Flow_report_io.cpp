// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Flow_report_io.h
#include <Conformal_geometry_processing/flow/Flow_report_io.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace cgp_test::flow_report_io_tests {

using namespace Conformal_geometry_processing;
using Stop = Flow_step_report::Stop;

std::string printed(const Flow_report& report)
{
  std::ostringstream out;
  out << report;
  return out.str();
}

std::string fault_of(const Flow_report& report)
{
  const std::string text = printed(report), name = "fault                  ";
  const std::size_t from = text.find(name);
  return from == std::string::npos ? "none is printed" : text.substr(from + name.size());
}

TEST(Flow_report_io, prints_why_a_flow_has_stopped_and_what_it_did)
{
  Flow_report report;
  report.steps.resize(12);
  report.stop = Stop::energy_settled;
  report.initial_energy = 20.5;
  report.energy = 12.625;
  report.period_defect = .03125;
  const std::string text = printed(report);
  for (const char* part : {"12; the energy has settled\n", "from 20.5 to 12.625\n",
                           "quasi-conformal error", "period defect 0.03125\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in\n" << text;
  EXPECT_EQ(text.find("last trial"), std::string::npos);
  report.message = "no luck";
  EXPECT_NE(printed(report).find("rejected: no luck\n"), std::string::npos);
}

TEST(Flow_report_io, tells_a_fault_exactly_if_the_flow_is_no_success)
{
  Flow_report report;
  report.stop = Stop::steps_done;
  ASSERT_TRUE(report);
  EXPECT_EQ(fault_of(report), "none\n");
  report.period_defect = .2;
  ASSERT_FALSE(report);
  EXPECT_EQ(fault_of(report), "the conformal type has changed\n");
  report.conformality.flipped_share = .5;
  EXPECT_EQ(fault_of(report), "too many faces are flipped\n");
  for (const Stop stop : {Stop::none, Stop::cancelled, Stop::time_step_too_small,
                          Stop::limits_reached, Stop::scale_range, Stop::step_failed}) {
    report.stop = stop;
    EXPECT_EQ(fault_of(report), std::string(to_string(stop)) + "\n");
  }
}

}  // namespace cgp_test::flow_report_io_tests
