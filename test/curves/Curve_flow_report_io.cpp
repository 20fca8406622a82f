// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/curves/Curve_flow_report_io.h
#include <Conformal_geometry_processing/curves/Curve_flow_report_io.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace cgp_test::curve_flow_report_io_tests {

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

}  // namespace cgp_test::curve_flow_report_io_tests
