// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Exact_steps.h
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Exact_steps.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <optional>
#include <utility>

#include "support/Counted_solver_traits.h"
#include "support/meshes.h"
#include "support/with_solvers.h"

namespace cgp_test::exact_steps_costs_tests {

/// How many matrices are factored for an edit of a surface with handles.

namespace CGP = Conformal_geometry_processing;

CGP::Spin_report edited(CGP::Spin_transformation& transformation, double amplitude)
{
  Counted_solver_traits::reset();
  const Eigen::VectorXd rho = amplitude * (3 * transformation.positions().row(1).array()).sin();
  return transformation.transform(CGP::Curvature_potential::on_vertices(rho)).report;
}

TEST(Exact_steps_costs, are_one_factorization_for_each_edit_after_the_first_in_one_step)
{
  CGP::Spin_transformation transformation(btorus(16), with_solvers<Counted_solver_traits>());
  EXPECT_EQ(edited(transformation, .1).steps, 1);
  EXPECT_EQ(Counted_solver_traits::quaternionic.factorizations,
            2);                                              // the constraints, and the edit
  EXPECT_EQ(Counted_solver_traits::real.factorizations, 2);  // the Laplacian, and the verdict
  EXPECT_EQ(edited(transformation, .2).steps, 1);
  EXPECT_EQ(Counted_solver_traits::quaternionic.factorizations, 1);
  EXPECT_EQ(Counted_solver_traits::real.factorizations, 1);
}

TEST(Exact_steps_costs, are_all_in_the_report)
{
  CGP::Spin_transformation_options strict;
  strict.max_period_defect = 1e-3;
  for (const auto& [amplitude, options] :
       {std::pair(.1, CGP::Spin_transformation_options()), std::pair(6., strict)}) {
    CGP::Spin_transformation transformation(btorus(16),
                                            with_solvers<Counted_solver_traits>(options));
    for (const bool is_first : {true, false}) {
      const CGP::Spin_report report = edited(transformation, amplitude);
      EXPECT_EQ(report.factorizations, Counted_solver_traits::quaternionic.factorizations);
      EXPECT_EQ(report.solves, Counted_solver_traits::quaternionic.solves);
      EXPECT_EQ(report.seconds.exactness > 0, is_first || report.steps > 1);
    }
  }
}

TEST(Exact_steps_costs, are_those_of_a_part_of_the_way_where_lengths_exceed_a_bound_by_far)
{
  const auto run = [](std::optional<double> bound) {
    CGP::Spin_transformation_options options;
    options.max_period_defect = 1e-3;
    options.scales.bound = bound;
    CGP::Spin_transformation transformation(btorus(16),
                                            with_solvers<Counted_solver_traits>(options));
    const Eigen::VectorXd rho = 6 * (3 * transformation.positions().row(1).array()).sin();
    return CGP::internal::Exact_steps(transformation, CGP::Curvature_potential::on_vertices(rho),
                                      options)
        .run({}, CGP::internal::Always_go_further());
  };
  const CGP::Spin_result all = run(std::nullopt), within = run(100), beyond = run(1.1);
  EXPECT_EQ(within.positions, all.positions);
  EXPECT_EQ(all.report.reached, 1);
  EXPECT_GT(all.report.steps, 2);
  EXPECT_GT(beyond.report.reached, 0);
  EXPECT_LT(beyond.report.reached, 1);
  EXPECT_LT(beyond.report.factorizations, all.report.factorizations);
  const Eigen::VectorXd areas = CGP::vertex_areas(btorus(16));
  EXPECT_TRUE(CGP::internal::exceeds_bound_by_far(beyond.lambda, areas, {1.1, {}, {}}));
}

TEST(Exact_steps_costs, are_one_factorization_more_for_each_change_that_closes_the_surface)
{
  CGP::Spin_transformation_options options;
  options.max_period_defect = 1e-5;
  CGP::Spin_transformation transformation(btorus(16), with_solvers<Counted_solver_traits>(options));
  (void)edited(transformation, .5);
  const CGP::Spin_report report = edited(transformation, .5);
  EXPECT_EQ(report.steps, 1);
  EXPECT_LE(report.period_defect, 1e-5);
  EXPECT_GE(Counted_solver_traits::quaternionic.factorizations, 2);
  EXPECT_LE(Counted_solver_traits::quaternionic.factorizations, 4);
  EXPECT_EQ(Counted_solver_traits::real.factorizations, 1);  // the verdict
}

}  // namespace cgp_test::exact_steps_costs_tests
