// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/flow/Flow_report.h>

#include <gtest/gtest.h>

#include "support/spheres.h"

#include <set>
#include <sstream>
#include <string>

namespace cgp_test::flow_report_tests {

using Conformal_geometry_processing::Flow_report;
using Flow_stop = Conformal_geometry_processing::Flow_step_report::Stop;
namespace CGP = Conformal_geometry_processing;

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
  report.initial_energy_of_faces = 20.5;
  report.energy_of_faces = 12.625;
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

TEST(Flow_visitor, must_not_call_back_the_flow)
{
  using Flow = CGP::Conformal_willmore_flow;
  struct Intruder : CGP::Flow_visitor {
    Flow* flow = nullptr;
    int refused = 0;
    void intrude()
    {
      EXPECT_THROW((void)flow->step(), CGP::Precondition_error);
      EXPECT_THROW((void)flow->run(), CGP::Precondition_error);
      ++refused;
    }
    void on_flow_begin(const Mesh_view&, double) { intrude(); }
    void on_iteration(const CGP::Eigensolver_progress&) { intrude(); }
    bool go_further() { return intrude(), true; }
    void on_step_end(const CGP::Flow_step_report&, const Mesh_view&) { intrude(); }
  } intruder;
  CGP::Flow_options options;
  options.max_steps = 3;
  Flow flow(bumpy_sphere(2), options), undisturbed(bumpy_sphere(2), options);
  intruder.flow = &flow;
  EXPECT_EQ(flow.run(intruder).steps.size(), undisturbed.run().steps.size());
  EXPECT_GT(intruder.refused, 4);
  EXPECT_EQ(flow.mesh().positions(), undisturbed.mesh().positions());
}

}  // namespace cgp_test::flow_report_tests
