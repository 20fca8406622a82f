// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Tests include/Conformal_geometry_processing/flow/Flow_options.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "flow_tools.h"

namespace cgp_test::conformal_willmore_flow_refusals_tests {

/// What a flow does not take.

struct Constant {
  double value;
  int size;
  Eigen::VectorXd operator()(const Mesh_view&) const
  {
    return Eigen::VectorXd::Constant(size, value);
  }
};

std::string refusal(const Mesh_view& mesh, const CGP::Flow_options& options = {})
{
  try {
    const CGP::Conformal_willmore_flow flow(mesh, options);
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const Constant& direction)
{
  CGP::Conformal_willmore_flow flow(icosphere(1), {}, direction);
  try {
    (void)flow.step();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(flow.mesh().positions(), icosphere(1).positions());
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(Conformal_willmore_flow_refusals, refuses_unsuitable_surfaces)
{
  const std::string apart = refusal(disjoint_union(icosphere(1), icosphere(1), {3, 0, 0}));
  EXPECT_TRUE(has(apart, "Conformal_willmore_flow: ")) << apart;
  EXPECT_TRUE(has(apart, "component")) << apart;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Points p = icosphere(1).positions();
  p(0, 5) = nan;
  EXPECT_TRUE(has(refusal(Mesh_view(p, icosphere(1).corners())), "vertex 5"));
}

TEST(Conformal_willmore_flow_refusals, refuses_options_out_of_their_ranges)
{
  CGP::Flow_options options;
  for (const double tau : {0., -1., std::numeric_limits<double>::infinity()}) {
    options.time_step = tau;
    EXPECT_TRUE(has(refusal(icosphere(1), options), "positive ones are needed"));
  }
  options = {};
  options.min_time_step = 0;
  EXPECT_TRUE(has(refusal(icosphere(1), options), "positive ones are needed"));
  options = {};
  options.max_steps = -1;
  EXPECT_TRUE(has(refusal(icosphere(1), options), "-1 steps"));
  options = {};
  options.filter_weight = -1;
  EXPECT_TRUE(has(refusal(icosphere(1), options), "a filter weight of -1"));
  options.filter_weight = 1;
  options.filter_order = -1;
  EXPECT_TRUE(has(refusal(icosphere(1), options), "an order of -1"));
  options = {};
  options.surface.boundary.kind = CGP::Boundary_condition::Kind::positions;
  EXPECT_TRUE(has(refusal(icosphere(1), options), "a flow can keep directions only"));
  options = {};
  options.surface.scales.bound = 1;
  EXPECT_TRUE(has(refusal(icosphere(1), options), "a number above 1 is needed"));
  options.surface.scales.bound = 2;
  EXPECT_EQ(refusal(icosphere(1), options), "");
  options.surface.scales.weights = Eigen::VectorXd::Ones(42);
  EXPECT_TRUE(has(refusal(icosphere(1), options), "a flow can keep a bound only"));
}

TEST(Conformal_willmore_flow_refusals, refuses_directions_that_are_no_functions_on_the_vertices)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(has(refusal(Constant{1, 7}), "the direction has 7 values, one per vertex"));
  EXPECT_TRUE(has(refusal(Constant{nan, 42}), "direction not finite"));
  EXPECT_EQ(refusal(Constant{1, 42}), "");
}

}  // namespace cgp_test::conformal_willmore_flow_refusals_tests
