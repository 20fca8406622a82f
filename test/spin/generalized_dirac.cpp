// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/generalized_dirac.h
#include <Conformal_geometry_processing/spin/generalized_dirac.h>

#include <gtest/gtest.h>

#include "spin/solved.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::generalized_dirac_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

CGP::Dirac_options generalized()
{
  CGP::Dirac_options options;
  options.problem = CGP::Dirac_options::Eigenproblem::generalized;
  return options;
}

Curvature_potential potential(const Mesh_view& mesh, double amplitude, double mean = 0)
{
  return Curvature_potential::on_faces(amplitude * rho_of_section_3_on_faces(mesh).array() + mean);
}

/// |X lambda - g K lambda| / |X lambda|
double residual(const Mesh_view& mesh, const Curvature_potential& rho,
                const CGP::internal::Dirac_solution& s)
{
  const Quaternion_vector<double> Xl = CGP::block_operator(CGP::dirac_energy(mesh, rho))(s.lambda);
  Quaternion_vector<double> r = CGP::block_operator(CGP::dirac_form(mesh, rho))(s.lambda);
  for (Eigen::Index v = 0; v < r.size(); ++v) r[v] = Xl[v] - s.generalized_eigenvalue * r[v];
  return CGP::components(r).norm() / CGP::components(Xl).norm();
}

// The eigenvalues come from an implementation that shares no code with this one.
TEST(Generalized_dirac, has_the_tabled_eigenvalues)
{
  for (const auto& [level, expected] :
       {std::pair(2, -0.1732272145), std::pair(3, -0.0680672257), std::pair(4, -0.0418786038)}) {
    const Mesh_view sphere = icosphere(level);
    const CGP::internal::Dirac_solution s = solved(sphere, potential(sphere, 1), generalized());
    EXPECT_TRUE(s.converged);
    ASSERT_TRUE(s.is_generalized);
    EXPECT_NEAR(s.generalized_eigenvalue, expected, 1e-9);
    EXPECT_LT(residual(sphere, potential(sphere, 1), s), 1e-5);
  }
}

TEST(Generalized_dirac, has_the_eigenvalue_that_the_error_of_the_standard_problem_predicts)
{
  const Mesh_view sphere = icosphere(3);
  CGP::internal::Dirac_system system(sphere);
  for (const double amplitude : {1., 0.3, -0.1}) {
    const CGP::internal::Dirac_solution standard =
        CGP::solve_dirac_equation(system, potential(sphere, amplitude));
    const CGP::internal::Dirac_solution s =
        CGP::solve_dirac_equation(system, potential(sphere, amplitude), generalized());
    ASSERT_TRUE(s.is_generalized);
    const double gamma = standard.eigenvalue, expected = gamma + standard.energy / gamma;
    EXPECT_NEAR(s.generalized_eigenvalue, expected, 2e-3 * std::abs(expected));
    EXPECT_LT(greatest_difference(s.lambda, standard.lambda), 0.02);
  }
}

TEST(Generalized_dirac, finds_positive_and_negative_eigenvalues)
{
  const Mesh_view sphere = icosphere(2);
  CGP::internal::Dirac_system system(sphere);
  for (const double mean : {-0.2, 0.2}) {
    const CGP::internal::Dirac_solution s =
        CGP::solve_dirac_equation(system, potential(sphere, 0.5, mean), generalized());
    ASSERT_TRUE(s.is_generalized);
    EXPECT_NEAR(s.generalized_eigenvalue, -mean, 0.1);
    EXPECT_LT(residual(sphere, potential(sphere, 0.5, mean), s), 1e-5);
  }
}

// Where gamma passes zero, gamma + delta^2 / gamma is anything.
TEST(Generalized_dirac, is_not_trusted_where_the_eigenvalue_vanishes)
{
  const Mesh_view sphere = icosphere(2);
  CGP::internal::Dirac_system system(sphere);
  const double mean = CGP::solve_dirac_equation(system, potential(sphere, 1)).eigenvalue;
  for (const double offset : {0., 1e-6, -1e-6}) {
    const Curvature_potential rho = potential(sphere, 1, mean + offset);
    const CGP::internal::Dirac_solution standard = CGP::solve_dirac_equation(system, rho),
                                        s = CGP::solve_dirac_equation(system, rho, generalized());
    EXPECT_NEAR(s.eigenvalue, -offset, 1e-8);
    EXPECT_TRUE(s.converged);
    EXPECT_FALSE(s.is_generalized);
    EXPECT_EQ(s.generalized_eigenvalue, 0);
    EXPECT_EQ(s.lambda, standard.lambda);
    EXPECT_EQ(s.residual, standard.residual);
  }
}

TEST(Generalized_dirac, keeps_the_standard_solution_for_rho_zero)
{
  const Mesh_view sphere = icosphere(2);
  const CGP::internal::Dirac_solution s = solved(sphere, potential(sphere, 0), generalized());
  EXPECT_TRUE(s.converged);
  EXPECT_FALSE(s.is_generalized);
  EXPECT_NEAR(s.overlap, 1, 1e-14);
}

// D has the eigenvalues 0, 1 and -2 on the sphere: with the mean 2 of rho the branch of the
// identity has -2, and -1 is nearer to zero.
TEST(Generalized_dirac, is_rejected_where_an_eigenvalue_of_the_same_sign_is_smaller)
{
  const Mesh_view sphere = icosphere(2);
  CGP::internal::Dirac_system system(sphere);
  const CGP::internal::Dirac_solution standard = CGP::solve_dirac_equation(system,
                                                                           potential(sphere, 1, 2)),
                                      s = CGP::solve_dirac_equation(system, potential(sphere, 1, 2),
                                                                    generalized());
  EXPECT_TRUE(s.converged);
  EXPECT_FALSE(s.is_generalized);
  EXPECT_EQ(s.lambda, standard.lambda);
  EXPECT_EQ(s.eigenvalue, standard.eigenvalue);
  EXPECT_EQ(s.factorizations, standard.factorizations + 1);
}

TEST(Generalized_dirac, can_be_cancelled)
{
  const Mesh_view sphere = icosphere(2);
  CGP::internal::Dirac_system system(sphere);
  const int standard = CGP::solve_dirac_equation(system, potential(sphere, 1)).iterations;
  int asked = 0;
  const auto stop = [&](const CGP::Eigensolver_progress&) { return ++asked <= standard + 1; };
  const CGP::internal::Dirac_solution s =
      CGP::solve_dirac_equation(system, potential(sphere, 1), generalized(), stop);
  EXPECT_TRUE(s.cancelled);
  EXPECT_FALSE(s.is_generalized);
}

TEST(Generalized_dirac, refuses_rho_on_vertices)
{
  const Mesh_view sphere = icosphere(1);
  const auto rho = Curvature_potential::on_vertices(rho_of_section_3_on_vertices(sphere));
  try {
    (void)solved(sphere, rho, generalized());
    FAIL();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_STREQ(error.what(),
                 "solve_dirac_equation: the generalized eigenproblem (5.2) needs rho on faces");
  }
}

}  // namespace cgp_test::generalized_dirac_tests
