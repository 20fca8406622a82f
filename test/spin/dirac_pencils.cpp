// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/solve_dirac_equation.h
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <gtest/gtest.h>

#include "spin/boundary_tools.h"
#include "spin/solved.h"
#include "support/dense.h"
#include "support/meshes.h"

#include <cmath>

namespace cgp_test::dirac_pencils_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Plane = CGP::internal::Reduced_basis<double>::Plane;
using CGP::Curvature_potential;
using Vectors = CGP::Block<Quaternion<double>>;

/// the spins that keep a direction: span(1, direction)
Plane keeping(const Q& direction)
{
  return {Q{1, 0, 0, 0}, direction};
}

TEST(Constant_spins, are_the_real_numbers_where_different_directions_are_kept)
{
  const CGP::internal::Reduced_basis<double> basis(4, {1, 3},
                                                   {keeping({0, 1, 0, 0}), keeping({0, 0, 1, 0})});
  const auto spins = CGP::constant_spins(basis);
  ASSERT_EQ(spins.size(), 1);
  EXPECT_NEAR(std::abs(spins[0].w), 1, 1e-14);
}

TEST(Constant_spins, hold_the_rotations_about_parallel_directions)
{
  const CGP::internal::Reduced_basis<double> basis(4, {1, 3},
                                                   {keeping({0, 0, 0, 1}), keeping({0, 0, 0, -1})});
  const auto spins = CGP::constant_spins(basis);
  ASSERT_EQ(spins.size(), 2);
  for (const Q& q : spins) {
    EXPECT_NEAR(CGP::norm(q), 1, 1e-14);
    EXPECT_NEAR(std::hypot(q.x, q.y), 0, 1e-14);
  }
  EXPECT_NEAR(CGP::dot(spins[0], spins[1]), 0, 1e-14);
}

TEST(Constant_spins, do_not_exist_where_directions_are_turned_differently)
{
  const CGP::internal::Reduced_basis<double> basis(
      2, {0, 1}, {keeping({0, 0, 0, 1}), Plane{Q{0, 1, 0, 0}, Q{0, 0, 1, 0}}});
  EXPECT_EQ(CGP::constant_spins(basis).size(), 0);
  EXPECT_EQ(CGP::constant_spins(CGP::internal::Reduced_basis<double>(3, {}, {})).size(), 4);
}

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

/// on a closed surface and on one with prescribed directions, whose spins are a real space
class Dirac_pencils : public testing::TestWithParam<bool> {
 protected:
  Dirac_pencils() { set_potential(rho); }

  void set_potential(const Curvature_potential& potential)
  {
    CGP::internal::Dirac_evidence::Seconds seconds;
    system.set_potential(potential, seconds);
  }

  /// a member of the space
  Vectors random_member(int seed) const
  {
    return system.projected(random_quaternions(mesh.size_of_vertices(), at(seed)));
  }

  /// M_V x
  Vectors times_masses(const Vectors& x) const { return CGP::block_operator(system.areas())(x); }

  const Mesh_view mesh = GetParam() ? perturbed(cap_from_disk(jittered_disk(4, .3), 1), .04)
                                    : radially_perturbed(icosphere(2), .1);
  const Curvature_potential rho =
      potential_on_faces(mesh, [](const auto& p) { return std::cos(2 * p.x() + 1); });
  CGP::internal::Dirac_system system{
      mesh, GetParam() ? Boundary_condition::binormals() : Boundary_condition::free()};
  const Vectors none = Vectors(mesh.size_of_vertices(), 0);
};

double greatest(const Vectors& x)
{
  return greatest_entry(x);
}

INSTANTIATE_TEST_SUITE_P(Closed_and_bounded, Dirac_pencils, testing::Bool());

TEST_P(Dirac_pencils, have_the_constants_in_their_kernel_for_rho_zero)
{
  const Vectors constants = CGP::internal::constants_in_space(system);
  ASSERT_EQ(constants.cols(), 1);
  set_potential(CGP::no_potential(mesh));
  EXPECT_LT(greatest(CGP::block_operator(system.matrix())(constants)), 1e-12);
  EXPECT_LT(greatest(system.projected(constants) - constants), 1e-14);
  EXPECT_NEAR(system.squared_norm(constants.col(0)), 1, 1e-13);
}

TEST_P(Dirac_pencils, solve_beside_the_constants)
{
  const Vectors constants = CGP::internal::constants_in_space(system);
  set_potential(CGP::no_potential(mesh));
  const Vectors b = random_member(2), x = CGP::internal::solve_beside(system, constants, b);
  const Vectors masses = times_masses(constants);
  EXPECT_LT(greatest(CGP::gram_matrix(masses, x, system.coefficients())), 1e-12);
  Vectors expected = b;
  CGP::add_combination(expected, masses,
                       Vectors(-CGP::gram_matrix(constants, b, system.coefficients())));
  const CGP::internal::Pencil pencil = CGP::internal::pencil_of_masses(system, constants);
  EXPECT_LT(greatest(pencil.N(x) - expected), 1e-10);
  EXPECT_LT(greatest(pencil.solve(b) - x), 1e-14);
}

TEST_P(Dirac_pencils, apply_the_matrices_of_the_system)
{
  const CGP::internal::Pencil masses = CGP::internal::pencil_of_masses(system, none);
  const Vectors x = random_member(3);
  EXPECT_LT(greatest(masses.K(x) - system.projected(times_masses(x))), 1e-14);
  const Vectors shifted =
      CGP::block_operator(system.matrix())(x) + times_masses(x) * system.shift();
  EXPECT_LT(greatest(masses.N(x) - system.projected(shifted)), 1e-12);
  EXPECT_EQ(masses.coefficients, system.coefficients());
  const CGP::internal::Pencil form = CGP::internal::pencil_of_form(system, rho, none);
  const auto K = CGP::dirac_form(mesh, rho);
  EXPECT_LT(greatest(form.K(x) - system.projected(CGP::block_operator(K)(x))), 1e-13);
  EXPECT_LT(greatest(form.N(x) - masses.N(x)), 1e-15);
}

TEST_P(Dirac_pencils, solve_with_their_second_matrix)
{
  for (const CGP::internal::Pencil& pencil : {CGP::internal::pencil_of_masses(system, none),
                                              CGP::internal::pencil_of_form(system, rho, none)}) {
    const Vectors b = random_member(4), x = pencil.solve(b);
    EXPECT_LT(greatest(system.projected(x) - x), 1e-11);
    EXPECT_LT(greatest(pencil.N(x) - b), 1e-10);
  }
}

TEST_P(Dirac_pencils, have_forms_over_the_numbers_of_the_space)
{
  Vectors v(mesh.size_of_vertices(), 2);
  v << random_member(5), random_member(6);
  const CGP::internal::Dirac_forms found = CGP::internal::forms_in_space(system, rho, v),
                                   all = CGP::dirac_forms(mesh, rho, v);
  for (Eigen::Index i = 0; i < 2; ++i)
    for (Eigen::Index j = 0; j < 2; ++j) {
      const auto reduced = [&](const Quaternion<double>& q) {
        return GetParam() ? Quaternion<double>{q.w, 0, 0, 0} : q;
      };
      EXPECT_EQ(found.dirac(i, j), reduced(all.dirac(i, j)));
      EXPECT_EQ(found.mass(i, j), reduced(all.mass(i, j)));
    }
}

}  // namespace cgp_test::dirac_pencils_tests
