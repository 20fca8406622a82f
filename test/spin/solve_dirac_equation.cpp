// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/solve_dirac_equation.h
// Tests include/Conformal_geometry_processing/spin/Dirac_solution.h
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "spin/solved.h"
#include "support/Counted_solver_traits.h"
#include "support/decompositions.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::solve_dirac_equation_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

Curvature_potential constant_on_faces(const Mesh_view& mesh, double c)
{
  return Curvature_potential::on_faces(Eigen::VectorXd::Constant(mesh.size_of_faces(), c));
}

Curvature_potential constant_on_vertices(const Mesh_view& mesh, double c)
{
  return Curvature_potential::on_vertices(Eigen::VectorXd::Constant(mesh.size_of_vertices(), c));
}

double distance_to_one(const Quaternion_vector<double>& lambda)
{
  return greatest_difference(lambda,
                             Quaternion_vector<double>::Constant(lambda.size(), {1, 0, 0, 0}));
}

/// rho on faces + c
Curvature_potential shifted(const Mesh_view& mesh, double c)
{
  return Curvature_potential::on_faces(rho_of_section_3_on_faces(mesh).array() + c);
}

/// all eigenvalues of X x = mu M_V x, from the matrices D, R and M_F; each of them four times
Eigen::VectorXd dense_eigenvalues(const Mesh_view& mesh, const Curvature_potential& rho)
{
  const Quaternion_matrix A = dense(CGP::dirac(mesh)) - dense(CGP::potential_matrix(mesh, rho));
  const Eigen::MatrixXd X = real_form(adjoint_product(A, CGP::face_areas(mesh), A));
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  Eigen::VectorXd scale(X.rows());
  for (Eigen::Index i = 0; i < X.rows(); ++i) scale[i] = 1 / std::sqrt(areas[i / 4]);
  const Eigen::MatrixXd symmetric = scale.asDiagonal() * X * scale.asDiagonal();
  return symmetric_eigenvalues(symmetric);
}

/// rho + c on either
Curvature_potential plus(const Curvature_potential& rho, double c)
{
  return {rho.on, (rho.values.array() + c).matrix()};
}

TEST(Solve_dirac_equation, for_rho_zero_is_solved_by_the_identity_without_an_iteration)
{
  for (const Mesh_view& mesh : {icosphere(2), torus(2, 1, 12, 9), tetrahedron()}) {
    const CGP::internal::Dirac_solution s = solved(mesh, constant_on_faces(mesh, 0));
    EXPECT_TRUE(s.converged);
    EXPECT_EQ(s.iterations, 0);
    EXPECT_EQ(s.substeps, 1);
    EXPECT_LT(distance_to_one(s.lambda), 1e-12);
    EXPECT_NEAR(s.eigenvalue, 0, 1e-14);
    EXPECT_NEAR(s.overlap, 1, 1e-14);
  }
}

TEST(Solve_dirac_equation, for_constant_rho_is_solved_by_the_identity)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.05);
  CGP::internal::Dirac_system system(mesh);
  for (const double c : {0.1, -0.5, 1., 3., -20.}) {
    for (const auto& rho : {constant_on_faces(mesh, c), constant_on_vertices(mesh, c)}) {
      const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
      EXPECT_TRUE(s.converged) << c;
      EXPECT_LT(distance_to_one(s.lambda), 1e-12) << c;
      EXPECT_NEAR(s.eigenvalue, -c, 1e-12) << c;
      EXPECT_LT(s.dirac_residual, 1e-12) << c;
    }
  }
}

TEST(Solve_dirac_equation, of_a_weak_rho_has_the_smallest_eigenvalue_of_the_dense_matrix)
{
  const double radius = 3;
  const Mesh_view sphere = icosphere(1), mesh = scaled(sphere, radius);
  CGP::internal::Dirac_system system(mesh);
  for (const auto& rho :
       {Curvature_potential::on_faces(0.5 / radius * rho_of_section_3_on_faces(sphere)),
        Curvature_potential::on_vertices(0.5 / radius * rho_of_section_3_on_vertices(sphere))}) {
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
    const Eigen::VectorXd mu = dense_eigenvalues(mesh, plus(rho, s.eigenvalue));
    EXPECT_NEAR(s.energy, mu[0], 1e-12);
    EXPECT_NEAR(s.dirac_residual, std::sqrt(mu[0]), 1e-10);
    EXPECT_GE(s.gap, std::sqrt(mu[4]));  // of a vector in the span, which is smaller than the space
    EXPECT_LE(s.branch_gap, s.gap);
  }
}

TEST(Solve_dirac_equation, has_a_solution_in_the_gauge_with_mean_real_and_mean_square_one)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.05);
  const CGP::internal::Dirac_solution s = solved(mesh, shifted(mesh, 0.2));
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  Quaternion<double> mean;
  double square = 0;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    mean += areas[v] / areas.sum() * s.lambda[v];
    square += areas[v] / areas.sum() * squared_norm(s.lambda[v]);
  }
  EXPECT_GT(mean.w, 0.5);
  EXPECT_LT(imaginary_part(mean).norm(), 1e-12);
  EXPECT_NEAR(square, 1, 1e-12);
  EXPECT_NEAR(s.overlap, mean.w, 1e-12);
}

TEST(Solve_dirac_equation, residual_is_that_of_the_equation)
{
  const Mesh_view mesh = icosphere(2);
  const auto rho = shifted(mesh, 0);
  for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
    CGP::Dirac_options options;
    options.tolerance = tolerance;
    const CGP::internal::Dirac_solution s = solved(mesh, rho, options);
    ASSERT_TRUE(s.converged);
    EXPECT_LE(s.residual, tolerance);
    const auto X = CGP::dirac_energy(mesh, plus(rho, s.eigenvalue));
    Quaternion_vector<double> r = CGP::block_operator(X)(s.lambda);
    const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
    for (int v = 0; v < mesh.size_of_vertices(); ++v) r[v] -= (s.energy * areas[v]) * s.lambda[v];
    // The largest eigenvalue of X is about 12: the dual norm bounds the plain one.
    EXPECT_LE(CGP::components(r).norm(), 4 * tolerance * std::sqrt(4 * pi));
  }
}

// The shift is the eigenvalue itself. With the mean -1 of rho, the normal, which has the eigenvalue
// -2 on the sphere, and the branch of the identity have nearly opposite eigenvalues.
TEST(Solve_dirac_equation, adds_a_constant_to_the_eigenvalue_and_nothing_to_lambda)
{
  const Mesh_view mesh = icosphere(3);
  CGP::internal::Dirac_system system(mesh);
  CGP::Dirac_options options;
  options.tolerance = 1e-10;
  const CGP::internal::Dirac_solution s0 =
      CGP::solve_dirac_equation(system, shifted(mesh, 0), options);
  for (const double c : {0.1, -0.2, -0.98, -1., -1.02, 1., 3.}) {
    const CGP::internal::Dirac_solution s =
        CGP::solve_dirac_equation(system, shifted(mesh, c), options);
    EXPECT_TRUE(s.converged) << c;
    EXPECT_NEAR(s.eigenvalue, s0.eigenvalue - c, 1e-9) << c;
    EXPECT_NEAR(s.spectral_shift, s0.spectral_shift - c, 1e-9) << c;
    EXPECT_LT(greatest_difference(s.lambda, s0.lambda), 1e-8) << c;
    EXPECT_EQ(s.factorizations, s0.factorizations) << c;
  }
}

TEST(Solve_dirac_equation, takes_one_factorization_where_rho_is_weak_whatever_its_mean)
{
  const Mesh_view mesh = icosphere(2);
  CGP::internal::Dirac_system system(mesh);
  for (const double mean : {0., -1.01, 4.})
    for (const double amplitude : {0.2, 1.}) {
      const auto rho = Curvature_potential::on_vertices(
          amplitude * rho_of_section_3_on_vertices(mesh).array() + mean);
      const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
      EXPECT_TRUE(s.converged);
      EXPECT_EQ(s.factorizations, 1) << mean << ' ' << amplitude;
      EXPECT_EQ(s.substeps, 1);
    }
}

TEST(Solve_dirac_equation, counts_its_factorizations_and_solves)
{
  const Mesh_view mesh = icosphere(2);
  CGP::internal::Dirac_system system(mesh, {}, "test", Counted_solver_traits());
  CGP::Dirac_options options;
  for (const double amplitude : {0., 1., 3., 5.})
    for (const auto problem : {CGP::Dirac_options::Eigenproblem::standard,
                               CGP::Dirac_options::Eigenproblem::generalized}) {
      options.problem = problem;
      Counted_solver_traits::reset();
      const auto rho = Curvature_potential::on_faces(amplitude * rho_of_section_3_on_faces(mesh));
      const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho, options);
      EXPECT_TRUE(s.converged) << amplitude;
      EXPECT_EQ(s.factorizations, Counted_solver_traits::quaternionic.factorizations) << amplitude;
      EXPECT_EQ(s.solves, Counted_solver_traits::quaternionic.solves) << amplitude;
    }
}

TEST(Solve_dirac_equation, is_solved_twice_to_the_same_bits)
{
  const Mesh_view mesh = icosphere(2);
  CGP::internal::Dirac_system system(mesh);
  for (const double amplitude : {1., 5.}) {
    const auto rho = Curvature_potential::on_faces(amplitude * rho_of_section_3_on_faces(mesh));
    const CGP::internal::Dirac_solution first = CGP::solve_dirac_equation(system, rho),
                                        second = CGP::solve_dirac_equation(system, rho);
    const CGP::internal::Dirac_solution fresh = solved(mesh, rho);
    EXPECT_EQ(first.lambda, second.lambda);
    EXPECT_EQ(first.lambda, fresh.lambda);
    EXPECT_EQ(first.eigenvalue, fresh.eigenvalue);
    EXPECT_EQ(first.iterations, fresh.iterations);
  }
}

TEST(Solve_dirac_equation, does_not_depend_on_the_random_start_beyond_the_tolerance)
{
  const Mesh_view mesh = icosphere(2);
  CGP::internal::Dirac_system system(mesh);
  CGP::Dirac_options options;
  const CGP::internal::Dirac_solution a =
      CGP::solve_dirac_equation(system, shifted(mesh, 0), options);
  options.random_seed = 7;
  const CGP::internal::Dirac_solution b =
      CGP::solve_dirac_equation(system, shifted(mesh, 0), options);
  EXPECT_LT(greatest_difference(a.lambda, b.lambda), 1e-7);
}

/// finds the next eigenpair in place of the wanted one, to all digits, in its first calls
struct Next_eigenpair {
  int* calls;  ///< that are left
  int* most_columns;

  template <class Masses, class Solver, class GoFurther>
  CGP::Eigensolver_result operator()(const CGP::Hermitian_sparse_matrix<CGP::Quaternion<double>>& A,
                                     const Masses& N, const Solver& solver,
                                     CGP::Block<CGP::Quaternion<double>> x0,
                                     CGP::Eigensolver_options options, GoFurther go_further) const
  {
    *most_columns = (std::max)(*most_columns, static_cast<int>(x0.cols()));
    const CGP::Lobpcg_eigensolver_traits lobpcg;
    if (--*calls < 0) return lobpcg(A, N, solver, std::move(x0), options, go_further);
    x0.conservativeResize(Eigen::NoChange, 2);
    x0.col(1) = random_block<CGP::Quaternion<double>>(static_cast<int>(x0.rows()), 1, 7).col(0);
    options.wanted = 2;
    options.adapt = {};
    auto pairs = lobpcg(A, N, solver, std::move(x0), options, go_further);
    pairs.vectors = pairs.vectors.rightCols(1).eval();
    pairs.values = pairs.values.tail(1).eval();
    pairs.estimates = pairs.estimates.tail(1).eval();
    return pairs;
  }
};

// One vector is asked for, so that copies of an eigenvalue cannot be missing.
TEST(Solve_dirac_equation, asks_for_one_vector_and_does_not_take_that_of_another_branch)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Curvature_potential rho = Curvature_potential::on_faces(rho_of_section_3_on_faces(mesh));
  const CGP::internal::Dirac_solution expected = solved(mesh, rho);
  ASSERT_TRUE(expected.converged);
  int most_columns = 0;
  for (const int wrong_calls : {1, 2, 1000}) {
    int calls = wrong_calls;
    CGP::Dirac_options options;
    options.eigensolver = Next_eigenpair{&calls, &most_columns};
    const CGP::internal::Dirac_solution s = solved(mesh, rho, options);
    EXPECT_EQ(s.converged, wrong_calls < 1000);
    if (s.converged) {
      EXPECT_NEAR(s.eigenvalue, expected.eigenvalue, 1e-8) << wrong_calls;
    }
  }
  EXPECT_EQ(most_columns, 1);
}

TEST(Solve_dirac_equation, reports_progress_and_stops_when_told)
{
  const Mesh_view mesh = icosphere(2);
  CGP::internal::Dirac_system system(mesh);
  int iterations = 0;
  const auto watch = [&](const CGP::Eigensolver_progress& p) {
    EXPECT_EQ(p.iteration, iterations++);
    return true;
  };
  EXPECT_EQ(CGP::solve_dirac_equation(system, shifted(mesh, 0), {}, watch).iterations, iterations);
  const auto stop = [](const CGP::Eigensolver_progress& p) { return p.iteration < 2; };
  const CGP::internal::Dirac_solution s =
      CGP::solve_dirac_equation(system, shifted(mesh, 0), {}, stop);
  EXPECT_TRUE(s.cancelled);
  EXPECT_FALSE(s.converged);
  EXPECT_EQ(s.iterations, 2);
}

TEST(Solve_dirac_equation, passes_on_what_the_observer_throws)
{
  const Mesh_view mesh = icosphere(1);
  CGP::internal::Dirac_system system(mesh);
  const auto bad = [](const CGP::Eigensolver_progress&) -> bool {
    throw std::runtime_error("bad");
  };
  EXPECT_THROW((void)CGP::solve_dirac_equation(system, shifted(mesh, 0), {}, bad),
               std::runtime_error);
  EXPECT_TRUE(CGP::solve_dirac_equation(system, shifted(mesh, 0)).converged);
}

}  // namespace cgp_test::solve_dirac_equation_tests
