// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/report_of_solution.h
// Tests include/Conformal_geometry_processing/spin/Spin_report.h
#include <Conformal_geometry_processing/spin/report_of_solution.h>

#include <gtest/gtest.h>

#include <limits>

namespace CGP = Conformal_geometry_processing;

TEST(Report_of_solution, has_curvatures_in_the_unit_of_the_mesh_and_pure_numbers_as_they_are)
{
  CGP::Dirac_solution s;
  s.eigenvalue = 3;
  s.gap = 5;
  s.spectral_shift = 7;
  s.generalized_eigenvalue = 11;
  s.residual = 13;
  s.overlap = .75;
  s.iterations = 17;
  s.substeps = 19;
  s.is_generalized = s.converged = true;
  const CGP::Spin_report r = CGP::report_of(s, 4);
  EXPECT_EQ(r.eigenvalue, .75);
  EXPECT_EQ(r.gap, 1.25);
  EXPECT_EQ(r.spectral_shift, 1.75);
  EXPECT_EQ(r.generalized_eigenvalue, 2.75);
  EXPECT_EQ(r.residual, 13);
  EXPECT_EQ(r.overlap, .75);
  EXPECT_EQ(r.iterations, 17);
  EXPECT_EQ(r.substeps, 19);
  EXPECT_TRUE(r.is_generalized);
  EXPECT_TRUE(r.converged);
  EXPECT_FALSE(r.cancelled);
}

TEST(Report_of_solution, has_not_converged_to_what_is_no_number)
{
  CGP::Dirac_solution s;
  s.converged = true;
  s.eigenvalue = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(CGP::report_of(s, 1).converged);
}

TEST(Spin_report, of_two_mollified_steps_tells_what_was_measured_in_the_first)
{
  CGP::Spin_report all, next;
  next.mollification = {1e-6, 1, 2, .5, 3, 40, .75};
  CGP::append(all, next);
  next.mollification = {1e-6, 2, 1, .25, 4, 30, .5};
  CGP::append(all, next);
  EXPECT_EQ(all.mollification.measured_faces, 40);
  EXPECT_EQ(all.mollification.measured_area, .75);
  EXPECT_EQ(all.mollification.thin_faces, 2);
  EXPECT_EQ(all.mollification.flipped_edges, 4);
}

TEST(Spin_report,
     of_two_transformations_transformations_adds_what_was_spent_and_keeps_the_worse_evidence)
{
  CGP::Spin_report all, next;
  all.steps = 2;
  all.iterations = 10;
  all.period_defect = .25;
  all.residual = 1e-9;
  all.gap = 3;
  next.steps = 3;
  next.iterations = 7;
  next.period_defect = .5;
  next.residual = 1e-8;
  next.gap = 4;
  CGP::append(all, next);
  EXPECT_EQ(all.steps, 5);
  EXPECT_EQ(all.iterations, 17);
  EXPECT_EQ(all.period_defect, .75);
  EXPECT_EQ(all.residual, 1e-8);
  EXPECT_EQ(all.gap, 3);
}
