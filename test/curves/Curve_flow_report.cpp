// Tests curves/polygons.h
// Tests include/Conformal_geometry_processing/curves/Isometric_curve_flow.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Isometric_curve_flow.h>
#include <Conformal_geometry_processing/curves/polygons.h>

#include <gtest/gtest.h>

#include "support/plane_curves.h"

#include <sstream>
#include <string>

namespace cgp_test::curve_flow_report_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Curve_flow_stop, has_words_for_every_reason)
{
  using Curve_flow_stop = CGP::Curve_step_report::Stop;
  for (const auto stop :
       {Curve_flow_stop::none, Curve_flow_stop::energy_settled, Curve_flow_stop::steps_done,
        Curve_flow_stop::cancelled, Curve_flow_stop::step_failed})
    EXPECT_STRNE(to_string(stop), "unknown");
  EXPECT_STREQ(to_string(static_cast<Curve_flow_stop>(-1)), "unknown");
}

TEST(Curve_flow_report, does_not_take_in_steps_that_failed)
{
  CGP::Curve_flow_report report;
  CGP::Curve_step_report step;
  step.stop = CGP::Curve_step_report::Stop::step_failed;
  EXPECT_FALSE(append(report, step));
  EXPECT_TRUE(report.steps.empty());
  EXPECT_FALSE(report);
}

TEST(Curve_frame, has_the_curve_around_its_origin)
{
  const Curve curve = (1e5 * flower(50)).colwise() + Eigen::Vector2d(3e8, 1);
  const CGP::internal::Curve_frame frame(curve);
  const Curve inside = frame.to_frame(curve);
  EXPECT_LT(inside.cwiseAbs().maxCoeff(), 2);
  EXPECT_GT(inside.cwiseAbs().maxCoeff(), .5);
  Curve back;
  frame.from_frame(inside, back);
  EXPECT_LT((back - curve).cwiseAbs().maxCoeff(), 1e-7);
}

using namespace Conformal_geometry_processing;
using Stop = Curve_step_report::Stop;

TEST(Curve_flow_report_io, tells_why_the_flow_has_stopped_and_whether_that_is_a_fault)
{
  for (const Stop stop :
       {Stop::none, Stop::energy_settled, Stop::steps_done, Stop::cancelled, Stop::step_failed}) {
    Curve_flow_report report;
    report.steps.resize(3);
    report.stop = stop;
    report.length = 2.5;
    report.energy = .75;
    std::ostringstream out;
    out << report;
    const std::string text = out.str(), reason = to_string(stop);
    EXPECT_NE(text.find("3; " + reason + "\n"), std::string::npos) << text;
    EXPECT_NE(text.find("length                 2.5,"), std::string::npos) << text;
    EXPECT_NE(text.find("from 0 to 0.75\n"), std::string::npos) << text;
    const std::string fault = report ? "none" : reason;
    EXPECT_NE(text.find("fault                  " + fault + "\n"), std::string::npos) << text;
  }
}

}  // namespace cgp_test::curve_flow_report_tests
