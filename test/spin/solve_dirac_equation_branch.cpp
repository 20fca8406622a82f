// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/solve_dirac_equation.h
// Tests include/Conformal_geometry_processing/spin/Dirac_branch.h
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include "spin/branch_tools.h"

namespace {

using namespace cgp_test;

class Branch_on_icosphere_3 : public testing::Test {
 protected:
  /// the solution is the vector that brute force finds
  void expect_branch(const Curvature_potential& rho, const CGP::internal::Dirac_solution& s)
  {
    const Branch_point expected = branch_of_identity(system, rho, 40);
    ASSERT_GT(expected.least_overlap, 0.98);
    EXPECT_TRUE(s.converged);
    EXPECT_LE(s.residual, 1e-8);
    // Vectors found with different shifts differ by the discretisation error.
    EXPECT_GT(system.overlap(s.lambda, expected.lambda), 0.995);
    EXPECT_NEAR(s.eigenvalue, expected.gamma, 0.02);
  }

  double overlap_of_smallest(const Curvature_potential& rho, const CGP::internal::Dirac_solution& s)
  {
    return system.overlap(smallest_eigenvector(system, rho), s.lambda);
  }

  const Mesh_view sphere = icosphere(3);
  CGP::internal::Dirac_system<> system{sphere};
};

}  // namespace

TEST_F(Branch_on_icosphere_3, is_found_at_once_among_the_two_smallest_though_it_is_not_the_first)
{
  const Curvature_potential rho = smooth_potential(sphere, 3);
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
  expect_branch(rho, s);
  EXPECT_EQ(s.substeps, 1);
  EXPECT_LT(overlap_of_smallest(rho, s), 0.1);
}

TEST_F(Branch_on_icosphere_3, is_followed_in_substeps_where_the_smallest_vectors_are_others)
{
  const Curvature_potential rho = smooth_potential(sphere, 5);
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
  expect_branch(rho, s);
  EXPECT_GT(s.substeps, 1);
  EXPECT_LT(overlap_of_smallest(rho, s), 0.1);
}

TEST_F(Branch_on_icosphere_3, of_forty_bumps_is_found)
{
  for (const double amplitude : {3., 4.}) {
    const Curvature_potential rho = bumps_potential(sphere, amplitude);
    expect_branch(rho, CGP::solve_dirac_equation(system, rho));
  }
}

TEST_F(Branch_on_icosphere_3, is_the_same_for_rho_on_faces)
{
  const auto on_faces = Curvature_potential::on_faces(4 * rho_of_section_3_on_faces(sphere));
  expect_branch(on_faces, CGP::solve_dirac_equation(system, on_faces));
}

TEST_F(Branch_on_icosphere_3, is_not_claimed_when_the_substeps_do_not_suffice)
{
  const Curvature_potential rho = smooth_potential(sphere, 5);
  CGP::Dirac_options options;
  for (const int enough_for_none : {1, 2, 3}) {
    options.max_substeps = enough_for_none;
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho, options);
    EXPECT_FALSE(s.converged);
    EXPECT_LE(s.substeps, enough_for_none);
  }
}

TEST_F(Branch_on_icosphere_3, is_not_claimed_when_the_iterations_do_not_suffice)
{
  CGP::Dirac_options options;
  options.max_iterations = 1;
  EXPECT_FALSE(CGP::solve_dirac_equation(system, smooth_potential(sphere, 1), options).converged);
  EXPECT_FALSE(CGP::solve_dirac_equation(system, smooth_potential(sphere, 5), options).converged);
}

TEST_F(Branch_on_icosphere_3, is_left_when_cancelled_within_the_substeps)
{
  int asked = 0;
  const auto stop = [&](const CGP::Eigensolver_progress&) { return ++asked < 12; };
  const CGP::internal::Dirac_solution s =
      CGP::solve_dirac_equation(system, smooth_potential(sphere, 5), {}, stop);
  EXPECT_TRUE(s.cancelled);
  EXPECT_FALSE(s.converged);
  EXPECT_EQ(asked, 12);
}
