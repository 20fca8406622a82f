// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/solve_dirac_equation.h
// Tests include/Conformal_geometry_processing/spin/Dirac_branch.h
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "spin/branch_tools.h"
#include "spin/coarse_cases.h"
#include "spin/dense_spectrum.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::solve_dirac_equation_invariance_tests {

/// What the solution does not depend on, and how it depends on rho, however coarse the mesh.

using CGP::internal::Dirac_solution;

const CGP::Dirac_options precise = [] {
  CGP::Dirac_options options;
  options.tolerance = 1e-10;
  return options;
}();

Dirac_solution precisely_solved(CGP::internal::Dirac_system& system, const Curvature_potential& rho)
{
  Dirac_solution s = CGP::solve_dirac_equation(system, rho, precise);
  EXPECT_TRUE(s.converged);
  return s;
}

double largest_value(const Curvature_potential& rho)
{
  return rho.values.cwiseAbs().maxCoeff();
}

/// whether the errors of discretisation are smaller than what separates the branches
bool is_resolved(const Dirac_solution& s)
{
  return s.dirac_residual < s.branch_gap / 2;
}

/// the amplitudes `step` k, k = 0..n, as long as the mesh resolves lambda
std::vector<Dirac_solution> sweep(CGP::internal::Dirac_system& system,
                                  const Curvature_potential& rho, double step, int n)
{
  std::vector<Dirac_solution> solutions;
  for (int k = 0; k <= n; ++k) {
    const Dirac_solution s = CGP::solve_dirac_equation(system, scaled(rho, step * k, 0), precise);
    if (k > 0 && !is_resolved(s)) break;
    EXPECT_TRUE(s.converged) << step * k;
    solutions.push_back(s);
  }
  return solutions;
}

double middle_of_gaps(const std::vector<Dirac_solution>& solutions)
{
  std::vector<double> gaps;
  for (const Dirac_solution& s : solutions) gaps.push_back(s.branch_gap);
  std::sort(gaps.begin(), gaps.end());
  return gaps[gaps.size() / 2];
}

/// the least mu of X for rho + sigma, from the dense matrix
double least_energy(const Mesh_view& mesh, const Curvature_potential& rho, double sigma)
{
  return dense_eigenvalues(mesh, scaled(rho, 1, sigma))[0];
}

TEST(Dirac_solution_of_a_coarse_mesh, is_the_same_for_rho_and_rho_plus_a_constant)
{
  for (const Coarse_case& c : coarse_cases()) {
    CGP::internal::Dirac_system system(c.mesh);
    for (const double amplitude : {.3, 1., 2.}) {
      const Curvature_potential rho = scaled(c.rho, amplitude, 0);
      const Dirac_solution s0 = precisely_solved(system, rho);
      for (const double constant : {.3, -.3, 2., -1.}) {
        const Dirac_solution s = precisely_solved(system, scaled(rho, 1, constant));
        EXPECT_LT(greatest_difference(s.lambda, s0.lambda), 1e-8)
            << c.name << ' ' << amplitude << ' ' << constant;
        EXPECT_NEAR(s.eigenvalue, s0.eigenvalue - constant, 1e-9) << c.name;
        EXPECT_NEAR(s.dirac_residual, s0.dirac_residual, 1e-9) << c.name;
      }
    }
  }
}

TEST(Dirac_solution_of_a_coarse_mesh, is_an_eigenvector_for_the_shift_by_its_own_quotient)
{
  for (const Coarse_case& c : coarse_cases()) {
    CGP::internal::Dirac_system system(c.mesh);
    for (const double amplitude : {.3, 1., 2.}) {
      const Curvature_potential rho = scaled(c.rho, amplitude, .4);
      const Dirac_solution s = precisely_solved(system, rho);
      const Curvature_potential moved = scaled(rho, 1, s.eigenvalue);
      EXPECT_NEAR(s.eigenvalue, CGP::dirac_quotient(c.mesh, rho, s.lambda), 1e-12) << c.name;
      EXPECT_NEAR(s.dirac_residual, CGP::dirac_misfit(c.mesh, moved, s.lambda), 1e-12) << c.name;
      EXPECT_NEAR(s.energy, s.dirac_residual * s.dirac_residual, 1e-9) << c.name;
      EXPECT_NEAR(CGP::dirac_quotient(c.mesh, moved, s.lambda), 0, 1e-12) << c.name;
    }
  }
}

// The derivative of mu with respect to the shift vanishes where the shift is the quotient.
TEST(Dirac_solution_of_a_coarse_mesh, has_less_energy_than_any_vector_has_for_a_shift_nearby)
{
  for (const Coarse_case& c : smallest_coarse_cases()) {
    CGP::internal::Dirac_system system(c.mesh);
    for (const double amplitude : {.3, 1.}) {
      const Curvature_potential rho = scaled(c.rho, amplitude, 0);
      const Dirac_solution s = precisely_solved(system, rho);
      EXPECT_NEAR(s.energy, least_energy(c.mesh, rho, s.eigenvalue), 1e-9) << c.name;
      for (const double distance : {1e-3, -1e-3, .02, -.02, .1, -.1})
        EXPECT_GT(least_energy(c.mesh, rho, s.eigenvalue + distance), s.energy)
            << c.name << ' ' << amplitude << ' ' << distance;
    }
  }
}

// The derivative of gamma with respect to the amplitude is minus a mean of rho.
TEST(Dirac_solution_of_a_coarse_mesh, changes_little_where_rho_does_but_where_branches_cross)
{
  const int n = 40;
  const double step = 3. / n;
  for (const Coarse_case& c : coarse_cases()) {
    CGP::internal::Dirac_system system(c.mesh);
    const std::vector<Dirac_solution> s = sweep(system, c.rho, step, n);
    EXPECT_GT(s.size(), 2U * n / 3) << c.name;
    const double small_gap = middle_of_gaps(s) / 5;
    for (std::size_t k = 1; k < s.size(); ++k) {
      const bool crosses = std::min(s[k - 1].branch_gap, s[k].branch_gap) < small_gap;
      EXPECT_TRUE(system.overlap(s[k - 1].lambda, s[k].lambda) > .9 || crosses)
          << c.name << ' ' << k << ' ' << s[k].branch_gap << " of " << middle_of_gaps(s);
      EXPECT_LE(std::abs(s[k].eigenvalue - s[k - 1].eigenvalue), largest_value(c.rho) * step)
          << c.name << ' ' << k;
    }
  }
}

}  // namespace cgp_test::solve_dirac_equation_invariance_tests
