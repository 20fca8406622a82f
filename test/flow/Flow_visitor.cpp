// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Flow_visitor.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/flow/Flow_visitor.h>

#include <gtest/gtest.h>

#include "support/spheres.h"

namespace cgp_test::flow_visitor_tests {

namespace CGP = Conformal_geometry_processing;

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

}  // namespace cgp_test::flow_visitor_tests
