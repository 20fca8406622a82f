// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/adapters/Slepc_eigensolver_traits.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "spin/gauge_tools.h"
#include "support/meshes.h"

namespace cgp_test::slepc_eigensolver_traits_tests {

using Q = Quaternion<double>;

CGP::Eigensolver_options options_for(double tolerance, int wanted, double scale = 1)
{
  CGP::Eigensolver_options options;
  options.tolerance = tolerance;
  options.wanted = wanted;
  options.scale = scale;
  return options;
}

// The matrix of a mesh with its direct solver.
struct Problem {
  explicit Problem(const Mesh_view& mesh_) : mesh(mesh_), dirac(mesh)
  {
    CGP::internal::Dirac_evidence::Seconds seconds;
    dirac.set_potential(CGP::Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh)),
                        seconds);
    start = random_block<Q>(mesh.size_of_vertices(), 2, 5);
  }

  template <class Eigensolver_traits, class GoFurther = CGP::internal::Always_go_further>
  CGP::Eigensolver_result solve(const CGP::Eigensolver_options& options,
                                GoFurther go_further = {}) const
  {
    return Eigensolver_traits()(dirac.matrix(), dirac.areas(), dirac.solver(), start, options,
                                go_further);
  }

  Mesh_view mesh;
  CGP::internal::Dirac_system dirac;
  CGP::Block<Q> start;
};

void expect_agreement(const Mesh_view& mesh, int wanted)
{
  const Problem problem(mesh);
  const auto options = options_for(1e-12, wanted, std::sqrt(problem.dirac.unit()));
  const auto direct = problem.solve<CGP::Lobpcg_eigensolver_traits>(options);
  const auto slepc = problem.solve<CGP::Slepc_eigensolver_traits>(options);
  EXPECT_TRUE(direct.converged);
  EXPECT_TRUE(slepc.converged);
  EXPECT_FALSE(slepc.cancelled);
  for (int c = 0; c < wanted; ++c) {
    EXPECT_NEAR(slepc.values[c], direct.values[c], 1e-10);
    EXPECT_LT(difference_up_to_right_quaternion(slepc.vectors.col(c), direct.vectors.col(c)),
              1e-10);
    EXPECT_LE(slepc.estimates[c], 1e-12);
    EXPECT_NEAR(
        CGP::inner_product(slepc.vectors.col(c), problem.dirac.areas(), slepc.vectors.col(c)).w, 1,
        1e-12);
  }
  ASSERT_TRUE(slepc.gap.has_value());
  EXPECT_NEAR(*slepc.gap, direct.values[1] - direct.values[0], 1e-3 * *slepc.gap);
}

TEST(Slepc_eigensolver_traits, agrees_with_the_direct_solution_on_a_noisy_sphere)
{
  expect_agreement(radially_perturbed(bumpy_sphere(3), 0.01), 1);
}

TEST(Slepc_eigensolver_traits, agrees_with_the_direct_solution_on_an_irregular_scan)
{
  expect_agreement(scan(600), 1);
}

TEST(Slepc_eigensolver_traits, finds_several_vectors)
{
  expect_agreement(radially_perturbed(bumpy_sphere(2), 0.01), 2);
}

// 1, 2, 3, ..., each with four eigenvectors: H D H for a reflection H = 1 - 2 v v^H
CGP::Hermitian_sparse_matrix<Q> with_fourfold_eigenvalues(const Pattern& pattern)
{
  const int n = pattern->size();
  CGP::Block<Q> v = random_block<Q>(n, 1, 3);
  CGP::scale_column(v, 0, 1 / std::sqrt(CGP::inner_product(v.col(0), v.col(0)).w));
  const auto H = [&](int i, int j) {
    return Q{i == j ? 1. : 0., 0, 0, 0} - 2. * (v(i, 0) * CGP::conjugate(v(j, 0)));
  };
  CGP::Hermitian_sparse_matrix<Q> A(pattern);
  int k = 0;
  A.for_each_entry([&](int i, int j, const Q&) {
    Q sum{0, 0, 0, 0};
    for (int l = 0; l < n; ++l) sum += H(i, l) * H(l, j) * (1. + l / 4);
    A.value(k++) = sum;
  });
  return A;
}

TEST(Slepc_eigensolver_traits, finds_all_copies_of_an_eigenvalue_from_any_start)
{
  const Pattern pattern = full_pattern(60);
  const auto A = with_fourfold_eigenvalues(pattern);
  const CGP::Vector<double> masses = CGP::Vector<double>::Ones(60);
  CGP::Supernodal_cholesky<Q> solver;
  ASSERT_EQ(solver.analyze(*pattern), CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  const auto options = options_for(1e-6, 6);
  for (int seed = 0; seed < 3; ++seed) {
    const auto x0 = random_block<Q>(60, 8, seed);
    for (const auto& found : {CGP::Lobpcg_eigensolver_traits()(A, masses, solver, x0, options),
                              CGP::Slepc_eigensolver_traits()(A, masses, solver, x0, options)}) {
      EXPECT_TRUE(found.converged);
      for (int c = 0; c < 6; ++c) EXPECT_NEAR(found.values[c], 1 + c / 4, 1e-10) << seed;
      EXPECT_NEAR(found.gap.value_or(1), 0, 1e-10);
    }
  }
}

TEST(Slepc_eigensolver_traits, solves_problems_too_small_for_slepc)
{
  const Pattern pattern = full_pattern(4);
  const auto A = random_definite<Q>(pattern, 1);
  const CGP::Vector<double> masses = random_numbers(4, 2).array() + 2;
  CGP::Supernodal_cholesky<Q> solver;
  ASSERT_EQ(solver.analyze(*pattern), CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  const auto x0 = random_block<Q>(4, 1, 3);
  const auto options = options_for(1e-10, 1);
  const auto expected = CGP::Lobpcg_eigensolver_traits()(A, masses, solver, x0, options);
  const auto result = CGP::Slepc_eigensolver_traits()(A, masses, solver, x0, options);
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(result.values[0], expected.values[0], 1e-10);
}

TEST(Slepc_eigensolver_traits, lets_itself_be_cancelled_after_any_iteration)
{
  const Problem problem(bumpy_sphere(2));
  for (const int last : {0, 2}) {
    int calls = 0;
    double value = 0;
    const auto result = problem.solve<CGP::Slepc_eigensolver_traits>(
        options_for(1e-12, 1), [&](const CGP::Eigensolver_progress& progress) {
          EXPECT_EQ(progress.iteration, calls);
          value = progress.value;
          return calls++ < last;
        });
    EXPECT_EQ(calls, last + 1);
    EXPECT_TRUE(result.cancelled);
    EXPECT_FALSE(result.converged);
    EXPECT_GT(value, 0);
    EXPECT_LE(result.values[0], value * (1 + 1e-12));
  }
}

TEST(Slepc_eigensolver_traits, is_cancelled_by_any_of_the_processes)
{
  const Problem problem(bumpy_sphere(2));
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  const auto result = problem.solve<CGP::Slepc_eigensolver_traits>(options_for(1e-12, 1),
                                                                   [&](auto) { return rank > 0; });
  EXPECT_TRUE(result.cancelled);
}

TEST(Slepc_eigensolver_traits, gives_up_after_the_iterations_allowed)
{
  const Problem problem(bumpy_sphere(2));
  auto options = options_for(1e-12, 1);
  for (const int allowed : {0, 1, 3}) {
    options.max_iterations = allowed;
    const auto result = problem.solve<CGP::Slepc_eigensolver_traits>(options);
    EXPECT_FALSE(result.converged);
    EXPECT_FALSE(result.cancelled);
    EXPECT_EQ(result.iterations, allowed);
    EXPECT_EQ(result.vectors.cols(), 2);
  }
}

TEST(Slepc_eigensolver_traits, passes_on_what_the_caller_throws)
{
  const Problem problem(bumpy_sphere(2));
  EXPECT_THROW(
      problem.solve<CGP::Slepc_eigensolver_traits>(
          options_for(1e-12, 1), [](auto) -> bool { throw std::out_of_range("enough of it"); }),
      std::out_of_range);
}

TEST(Slepc_eigensolver_traits, refuses_to_find_more_than_it_has_vectors)
{
  const Problem problem(bumpy_sphere(1));
  EXPECT_THROW(problem.solve<CGP::Slepc_eigensolver_traits>(options_for(1e-6, 3)),
               CGP::Precondition_error);
}

TEST(Slepc_eigensolver_traits, refuses_values_that_are_not_finite)
{
  const Problem problem(bumpy_sphere(1));
  auto A = problem.dirac.matrix();
  A.value(3) = {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};
  EXPECT_THROW(CGP::Slepc_eigensolver_traits()(A, problem.dirac.areas(), problem.dirac.solver(),
                                               problem.start),
               CGP::Solver_error);
}

}  // namespace cgp_test::slepc_eigensolver_traits_tests
