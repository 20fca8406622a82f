// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Dirac_solution.h
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <gtest/gtest.h>

#include <limits>

namespace cgp_test::dirac_solution_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Dirac_evidence, has_curvatures_in_the_unit_of_the_mesh_and_pure_numbers_as_they_are)
{
  CGP::internal::Dirac_solution s;
  s.eigenvalue = 3;
  s.gap = 5;
  s.dirac_residual = 6;
  s.branch_gap = 9;
  s.spectral_shift = 7;
  s.generalized_eigenvalue = 11;
  s.residual = 13;
  s.overlap = .75;
  s.iterations = 17;
  s.substeps = 19;
  s.factorizations = 23;
  s.solves = 29;
  s.is_generalized = s.converged = true;
  CGP::Spin_report r;
  r.steps = 3;
  static_cast<CGP::internal::Dirac_evidence&>(r) = CGP::in_units(s, 4);
  EXPECT_EQ(r.eigenvalue, .75);
  EXPECT_EQ(r.gap, 1.25);
  EXPECT_EQ(r.dirac_residual, 1.5);
  EXPECT_EQ(r.branch_gap, 2.25);
  EXPECT_EQ(r.spectral_shift, 1.75);
  EXPECT_EQ(r.generalized_eigenvalue, 2.75);
  EXPECT_EQ(r.residual, 13);
  EXPECT_EQ(r.overlap, .75);
  EXPECT_EQ(r.iterations, 17);
  EXPECT_EQ(r.substeps, 19);
  EXPECT_EQ(r.factorizations, 23);
  EXPECT_EQ(r.solves, 29);
  EXPECT_TRUE(r.is_generalized);
  EXPECT_TRUE(r.converged);
  EXPECT_FALSE(r.cancelled);
  EXPECT_EQ(r.steps, 3);
}

TEST(Dirac_evidence, adds_up_costs)
{
  CGP::internal::Dirac_solution a, b;
  a.iterations = 1, b.iterations = 2;
  a.factorizations = 4, b.factorizations = 8;
  a.solves = 16, b.solves = 32;
  add_costs(a, b);
  EXPECT_EQ(a.iterations, 3);
  EXPECT_EQ(a.factorizations, 12);
  EXPECT_EQ(a.solves, 48);
  a.seconds = {1, 2, 4}, b.seconds = {8, 16, 32};
  add_costs(a.seconds, b.seconds);
  EXPECT_EQ(a.seconds.assembly, 9);
  EXPECT_EQ(a.seconds.factorization, 18);
  EXPECT_EQ(a.seconds.eigenvectors, 36);
}

TEST(Dirac_evidence, has_not_converged_to_what_is_no_number)
{
  CGP::internal::Dirac_solution s;
  s.converged = true;
  s.eigenvalue = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(CGP::in_units(s, 1).converged);
}

}  // namespace cgp_test::dirac_solution_tests
