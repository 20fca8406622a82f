// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_report.h
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <gtest/gtest.h>

namespace CGP = Conformal_geometry_processing;

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

TEST(Spin_report, of_two_transformations_adds_what_was_spent_and_keeps_the_worse_evidence)
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
