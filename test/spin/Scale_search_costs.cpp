// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Scale_search.h
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include "support/Counted_solver_traits.h"
#include "support/limbs.h"
#include "support/with_solvers.h"

namespace cgp_test::scale_search_costs_tests {

/// How many matrices are factored for an edit with a bound on lengths, and how often factors serve.

namespace CGP = Conformal_geometry_processing;

void expect_counted(const Mesh_view& mesh, double amplitude, double bound)
{
  CGP::Spin_transformation_options options;
  options.scales.bound = bound;
  CGP::Spin_transformation transformation(mesh, with_solvers<Counted_solver_traits>(options));
  Counted_solver_traits::reset();
  const auto rho = CGP::Curvature_potential::on_vertices(rings(mesh, amplitude, 3));
  const CGP::Spin_report report = transformation.transform(rho).report;
  EXPECT_TRUE(report) << to_string(report.fault());
  EXPECT_GT(report.scales.weight, 0);
  EXPECT_EQ(report.factorizations, Counted_solver_traits::quaternionic.factorizations);
  EXPECT_EQ(report.solves, Counted_solver_traits::quaternionic.solves);
}

TEST(Scale_search_costs, are_all_in_the_report)
{
  expect_counted(dumbbell(2), .5, 1.5);
  expect_counted(dumbbell(3), .6, 2);
}

TEST(Scale_search_costs, are_all_in_the_report_of_a_surface_with_handles)
{
  expect_counted(btorus(16), 3, 1.3);
}

}  // namespace cgp_test::scale_search_costs_tests
