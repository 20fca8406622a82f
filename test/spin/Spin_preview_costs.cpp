// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_preview.h
#include <Conformal_geometry_processing/spin/Spin_preview.h>

#include <gtest/gtest.h>

#include "support/Counted_solver_traits.h"
#include "support/meshes.h"
#include "support/with_solvers.h"

namespace cgp_test::spin_preview_costs_tests {

/// What a preview costs: no factorization, and as many solves as the report says.

namespace CGP = Conformal_geometry_processing;

TEST(Spin_preview_costs, are_all_in_the_report)
{
  for (const Mesh_view& mesh : {icosphere(3), jittered_disk(8, .2), btorus(16)}) {
    CGP::Spin_transformation transformation(mesh, with_solvers<Counted_solver_traits>());
    CGP::internal::Spin_preview preview(transformation);
    for (const double amplitude : {.2, .4}) {
      const Eigen::VectorXd rho = amplitude * (3 * mesh.positions().row(1).array()).sin();
      Counted_solver_traits::reset();
      const CGP::Spin_report report =
          preview.transform(CGP::Curvature_potential::on_vertices(rho)).report;
      EXPECT_GT(report.solves, 0);
      EXPECT_EQ(report.solves, Counted_solver_traits::quaternionic.solves);
      EXPECT_EQ(report.factorizations, Counted_solver_traits::quaternionic.factorizations);
    }
    EXPECT_EQ(Counted_solver_traits::factorizations(), 0);  // of the second
  }
}

}  // namespace cgp_test::spin_preview_costs_tests
