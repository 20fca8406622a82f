// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/solve_dirac_equation.h
// Tests include/Conformal_geometry_processing/spin/Dirac_branch.h
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <cmath>
#include <utility>
#include <vector>

#include "spin/branch_tools.h"
#include "spin/coarse_cases.h"
#include "support/limbs.h"

namespace cgp_test::solve_dirac_equation_branch_tests {

class Branch_on_icosphere_3 : public testing::Test {
 protected:
  /// the solution is the vector that brute force finds, to the digits that were asked for
  void expect_branch(const Curvature_potential& rho, const CGP::internal::Dirac_solution& s)
  {
    const Branch_point expected = settled(system, rho, branch_of_identity(system, rho, 40));
    ASSERT_GT(expected.least_overlap, 0.98);
    EXPECT_TRUE(s.converged);
    EXPECT_LE(s.residual, 1e-8);
    EXPECT_GT(system.overlap(s.lambda, expected.lambda), 1 - 1e-10);
    EXPECT_NEAR(s.eigenvalue, expected.gamma, 1e-7);
  }

  double overlap_of_smallest(const Curvature_potential& rho, const CGP::internal::Dirac_solution& s)
  {
    return system.overlap(smallest_eigenvector(system, rho), s.lambda);
  }

  const Mesh_view sphere = icosphere(3);
  CGP::internal::Dirac_system system{sphere};
};

TEST_F(Branch_on_icosphere_3, is_followed_where_the_smallest_vector_is_another)
{
  for (const double amplitude : {3., 5.}) {
    const Curvature_potential rho = smooth_potential(sphere, amplitude);
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
    expect_branch(rho, s);
    EXPECT_LT(overlap_of_smallest(rho, s), 0.1);
  }
}

TEST_F(Branch_on_icosphere_3, of_mild_rho_is_found_in_one_stage_with_one_factor)
{
  for (const double amplitude : {0.3, 1.}) {
    const Curvature_potential rho = smooth_potential(sphere, amplitude);
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
    expect_branch(rho, s);
    EXPECT_EQ(s.substeps, 1);
    EXPECT_EQ(s.factorizations, 1);
  }
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

TEST_F(Branch_on_icosphere_3, is_not_claimed_when_the_stages_do_not_suffice)
{
  const Curvature_potential rho = smooth_potential(sphere, 5);
  const int needed = CGP::solve_dirac_equation(system, rho).substeps;
  ASSERT_GT(needed, 1);
  CGP::Dirac_options options;
  for (options.max_substeps = 1; options.max_substeps < needed; ++options.max_substeps) {
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho, options);
    EXPECT_FALSE(s.converged);
    EXPECT_EQ(s.substeps, options.max_substeps);
  }
  EXPECT_TRUE(CGP::solve_dirac_equation(system, rho, options).converged);
}

TEST_F(Branch_on_icosphere_3, is_not_claimed_when_the_iterations_do_not_suffice)
{
  CGP::Dirac_options options;
  options.max_iterations = 1;
  EXPECT_FALSE(CGP::solve_dirac_equation(system, smooth_potential(sphere, 1), options).converged);
  EXPECT_FALSE(CGP::solve_dirac_equation(system, smooth_potential(sphere, 5), options).converged);
}

TEST_F(Branch_on_icosphere_3, is_left_when_cancelled_within_the_stages)
{
  int asked = 0;
  const auto stop = [&](const CGP::Eigensolver_progress&) { return ++asked < 12; };
  const CGP::internal::Dirac_solution s =
      CGP::solve_dirac_equation(system, smooth_potential(sphere, 5), {}, stop);
  EXPECT_TRUE(s.cancelled);
  EXPECT_FALSE(s.converged);
  EXPECT_EQ(asked, 12);
}

// The vectors of each small step are those of another shift than the last one: hence it is settled.
TEST(Branch_on_a_coarse_mesh, is_found_with_at_most_two_factors_where_rho_is_mild)
{
  for (const Coarse_case& c : coarse_cases()) {
    CGP::internal::Dirac_system system(c.mesh);
    for (const double amplitude : {.3, .6, 1., 1.5}) {
      const Curvature_potential rho = scaled(c.rho, amplitude, 0);
      const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
      const Branch_point at = branch_of_identity(system, rho, 40);
      const Branch_point expected = settled(system, rho, at);
      ASSERT_GT(at.least_overlap, .9) << c.name << ' ' << amplitude;
      EXPECT_TRUE(s.converged) << c.name << ' ' << amplitude;
      EXPECT_GT(system.overlap(s.lambda, expected.lambda), 1 - 1e-8) << c.name << ' ' << amplitude;
      EXPECT_NEAR(s.eigenvalue, expected.gamma, 1e-6) << c.name << ' ' << amplitude;
      EXPECT_LE(s.factorizations, amplitude <= 1 ? 2 : 4) << c.name << " " << amplitude;
    }
  }
}

/// varies along all axes
Curvature_potential waves(const Mesh_view& mesh)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    rho[v] = std::sin(3 * p.x() + 1) * std::cos(4 * p.z()) + p.y() / 2;
  }
  return Curvature_potential::on_vertices(std::move(rho));
}

TEST(Branch_on_a_dumbbell, is_followed_in_one_stage_however_much_its_vector_turns)
{
  const Mesh_view mesh = scaled_to_area(dumbbell(2), 4 * pi);
  CGP::internal::Dirac_system system(mesh);
  for (const double amplitude : {.3, .5, 1.}) {
    const Curvature_potential rho = scaled(waves(mesh), amplitude, 0);
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
    const Branch_point expected = settled(system, rho, branch_of_identity(system, rho, 40));
    EXPECT_TRUE(s.converged);
    EXPECT_LT(s.overlap, .85) << amplitude;
    EXPECT_EQ(s.substeps, 1) << amplitude;
    EXPECT_LE(s.factorizations, 2) << amplitude;
    EXPECT_GT(system.overlap(s.lambda, expected.lambda), 1 - 1e-8) << amplitude;
    EXPECT_NEAR(s.eigenvalue, expected.gamma, 1e-6) << amplitude;
  }
}

// Where balls hang together by a neck, branches that belong to one ball each cross.
TEST(Branch_on_a_dumbbell, is_not_left_for_another_as_rho_grows)
{
  const Mesh_view mesh = scaled_to_area(dumbbell(2), 4 * pi);
  CGP::internal::Dirac_system system(mesh);
  Quaternion_vector<double> last = identity_spins(mesh);
  for (int k = 1; k <= 30; ++k) {
    const Curvature_potential rho = scaled(waves(mesh), .1 * k, 0);
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
    EXPECT_TRUE(s.converged) << k;
    EXPECT_GT(system.overlap(s.lambda, last), .9) << k;
    EXPECT_LE(s.factorizations, 10) << k;
    last = s.lambda;
  }
}

// The dense work of a stage grows with the cube of the span. With few vectors it is bounded by a
// multiple of the solves, of which each stage has one at least.
TEST(Branch_in_a_span, has_few_vectors_whatever_the_mesh_and_rho)
{
  const int most = 20;
  CGP::Dirac_options options;
  options.max_substeps = 100;
  std::vector<Coarse_case> cases = coarse_cases();
  const Mesh_view limbs = scaled_to_area(dumbbell(2), 4 * pi);
  cases.push_back({"dumbbell", limbs, waves(limbs)});
  for (const Coarse_case& c : cases) {
    CGP::internal::Dirac_system system(c.mesh);
    for (const double amplitude : {1., 4., 16., 64.}) {
      const auto s = CGP::solve_dirac_equation(system, scaled(c.rho, amplitude, 0), options);
      EXPECT_GE(s.largest_span, 2) << c.name << ' ' << amplitude;
      EXPECT_LE(s.largest_span, most) << c.name << ' ' << amplitude;
      EXPECT_LE(s.substeps, s.solves) << c.name << ' ' << amplitude;
    }
  }
}

}  // namespace cgp_test::solve_dirac_equation_branch_tests
