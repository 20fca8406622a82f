// Tests include/Conformal_geometry_processing/spin/Dirac_spectrum.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>

#include <gtest/gtest.h>

namespace cgp_test::dirac_spectrum_tests {

namespace CGP = Conformal_geometry_processing;

TEST(With_multiplicities, joins_what_is_nearer_than_the_resolution)
{
  const Eigen::VectorXd values = (Eigen::VectorXd(6) << 2.04, -1, 1.96, 0.5, 2, 0.5).finished();
  const auto groups = CGP::with_multiplicities(values, 0.1);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].value, -1);
  EXPECT_EQ(groups[0].multiplicity, 1);
  EXPECT_EQ(groups[1].value, 0.5);
  EXPECT_EQ(groups[1].multiplicity, 2);
  EXPECT_NEAR(groups[2].value, 2, 1e-15);
  EXPECT_EQ(groups[2].multiplicity, 3);
}

TEST(Dirac_spectrum, is_complete_if_all_that_was_asked_for_is_in_the_window)
{
  CGP::internal::Dirac_spectrum s;
  s.shift = 2;
  s.wanted = 2;
  s.eigenvalues = Eigen::Vector2d(2.5, 1.25);
  s.complete_radius = 0.8;
  EXPECT_FALSE(s.is_complete());  // not converged
  s.converged = true;
  EXPECT_TRUE(s.is_complete());
  s.complete_radius = 0.7;
  EXPECT_FALSE(s.is_complete());
  s.complete_radius = 0.8;
  s.wanted = 3;
  EXPECT_FALSE(s.is_complete());
}

TEST(With_multiplicities, of_nothing_is_nothing)
{
  EXPECT_TRUE(CGP::with_multiplicities(Eigen::VectorXd(), 1).empty());
}

}  // namespace cgp_test::dirac_spectrum_tests
