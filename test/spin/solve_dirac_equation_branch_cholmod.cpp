// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/solve_dirac_equation.h
// Tests include/Conformal_geometry_processing/spin/Dirac_branch.h
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include "spin/branch_tools.h"

namespace cgp_test::solve_dirac_equation_branch_cholmod_tests {

class Branch_on_icosphere_4 : public testing::Test {
 protected:
  CGP::internal::Dirac_solution expect_branch(const Curvature_potential& rho)
  {
    CGP::internal::Dirac_system system(sphere);
    CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
    const Branch_point expected = settled(system, rho, branch_of_identity(system, rho, 20));
    EXPECT_GT(expected.least_overlap, 0.98);
    EXPECT_TRUE(s.converged);
    EXPECT_GT(system.overlap(s.lambda, expected.lambda), 1 - 1e-10);
    EXPECT_NEAR(s.eigenvalue, expected.gamma, 1e-7);
    return s;
  }

  const Mesh_view sphere = icosphere(4);
};

TEST_F(Branch_on_icosphere_4, of_a_mild_potential_is_found_in_one_stage)
{
  const CGP::internal::Dirac_solution s = expect_branch(smooth_potential(sphere, 1));
  EXPECT_EQ(s.substeps, 1);
  EXPECT_EQ(s.factorizations, 1);
}

TEST_F(Branch_on_icosphere_4, of_strong_potentials_is_found_in_few_stages)
{
  for (const Curvature_potential& rho : {smooth_potential(sphere, 3), bumps_potential(sphere, 4)}) {
    const CGP::internal::Dirac_solution s = expect_branch(rho);
    EXPECT_LE(s.substeps, 4);
  }
}

}  // namespace cgp_test::solve_dirac_equation_branch_cholmod_tests
