// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/rotor.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "quaternionic_linear_algebra/reduced_problem.h"
#include "quaternionic_linear_algebra/reduced_solver_laws.h"
#include "support/decompositions.h"

namespace cgp_test::reduced_hermitian_solver_tests {

using CGP::internal::Reduced_hermitian_solver;
using Q = Quaternion<double>;
using Models = testing::Types<Reduced_hermitian_solver>;
using Vectors = CGP::Block<Q>;

INSTANTIATE_TYPED_TEST_SUITE_P(Automatic, Reduced_solver, Models);

template <class Solver>
Eigen::MatrixXd solution(const Reduced_problem& p, const CGP::Block<Q>& b)
{
  Solver solver;
  EXPECT_EQ(solver.analyze(p.X.pattern(), p.rows(), CGP::amd_ordering(p.X.pattern())),
            Solver_status::success);
  EXPECT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::success);
  CGP::Block<Q> x;
  EXPECT_EQ(solver.solve(b, x), Solver_status::success);
  return real_columns(x);
}

TEST(Reduced_hermitian_solver, has_two_forms_that_agree)
{
  for (const Mesh_view& mesh : {disk(12), annulus(1, 2, 60, 10), grid(60, 4)}) {
    const Reduced_problem p = reduced_problem(mesh, 1);
    const auto b = random_block<Q>(p.X.size(), 2, 2);
    const Eigen::MatrixXd real = solution<CGP::internal::Real_reduced_solver>(p, b);
    EXPECT_LE((solution<CGP::internal::Schur_reduced_solver>(p, b) - real).norm(),
              1e-11 * real.norm());
    EXPECT_LE((solution<Reduced_hermitian_solver>(p, b) - real).norm(), 1e-11 * real.norm());
  }
}

TEST(Reduced_hermitian_solver, takes_the_form_that_suits_the_mesh)
{
  for (const bool is_strip : {false, true}) {
    const Mesh_view mesh = is_strip ? grid(200, 3, 200, 3) : disk(8);
    const Reduced_problem p = reduced_problem(mesh, 3);
    const auto b = random_block<Q>(p.X.size(), 1, 4);
    Reduced_hermitian_solver solver;
    for (const bool with_positions : {false, true}) {
      ASSERT_EQ(with_positions
                    ? solver.analyze_with_positions(p.X.pattern(), p.rows(), mesh.positions())
                    : solver.analyze(p.X.pattern(), p.rows()),
                Solver_status::success);
      EXPECT_EQ(solver.has_real_form(), is_strip);
      ASSERT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::success);
      const Eigen::MatrixXd expected = solution<CGP::internal::Real_reduced_solver>(p, b);
      EXPECT_LE((real_columns(CGP::inverse_operator(solver)(b)) - expected).norm(),
                1e-11 * expected.norm());
    }
  }
}

TEST(Reduced_hermitian_solver, refuses_positions_and_rows_of_another_mesh)
{
  const Reduced_problem p = reduced_problem(disk(3), 5);
  Reduced_hermitian_solver solver;
  EXPECT_EQ(solver.analyze_with_positions(p.X.pattern(), p.rows(), Eigen::Matrix3Xd(3, 2)),
            Solver_status::wrong_state);
  EXPECT_EQ(solver.analyze(p.X.pattern(), CGP::internal::Reduced_rows(2, {})),
            Solver_status::wrong_state);
  EXPECT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::wrong_state);
}

TEST(Reduced_operator, is_the_reduced_matrix_on_embedded_vectors)
{
  const Reduced_problem p = reduced_problem(random_pattern(12, 1), {3, 0, 7}, 2);
  const auto basis = p.basis();
  const Eigen::MatrixXd B = p.dense_basis(), c = random_block<double>(p.rows().dimension(), 2, 3);
  const Vectors y = CGP::reduced_operator(p.X, basis)(basis.embed(c));
  const Eigen::MatrixXd expected = B * (B.transpose() * real_form(p.X) * B) * c;
  EXPECT_LE((real_columns(y) - expected).norm(), 1e-14 * expected.norm());
}

TEST(Real_gram_matrix, is_the_real_part_of_the_inner_products)
{
  const auto A = random_block<Q>(5, 3, 4), C = random_block<Q>(5, 2, 5);
  const Eigen::MatrixXd G = CGP::real_gram_matrix(A, C);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
      EXPECT_NEAR(G(i, j), CGP::inner_product(A.col(i), C.col(j)).w, 1e-14);
}

/// a flat disk whose binormals, the outward radii, are turned into `sign` times themselves
Reduced_problem disk_with_binormals(const Mesh_view& mesh, double sign)
{
  const std::vector<int> boundary = vertices_of_boundary(mesh);
  std::vector<Plane> planes;
  for (int i : boundary) {
    const Eigen::Vector3d radius = mesh.position(i).normalized(), target = sign * radius;
    const Q q = CGP::rotor(radius, target);
    planes.push_back({q, -(q * CGP::imaginary(target))});
  }
  const auto zero = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  return {CGP::dirac_energy(mesh, CGP::Curvature_potential::on_vertices(zero)),
          1e-3 * CGP::vertex_areas(mesh), boundary, planes};
}

/// the smallest eigenvalues of the reduced X relative to the areas, ascending, and their vectors:
/// power iteration with the inverse on a block, combined with real coefficients
Eigen::VectorXd smallest_eigenvalues(const Reduced_problem& p, int iterations, Vectors& x)
{
  const auto basis = p.basis();
  const Eigen::VectorXd areas = 1e3 * p.shift;
  CGP::internal::Real_reduced_solver solver;
  EXPECT_EQ(solver.analyze(p.X.pattern(), p.rows(), random_permutation(p.X.size(), 6)),
            CGP::Solver_status::success);
  EXPECT_EQ(solver.factorize(p.X, p.shift, basis), CGP::Solver_status::success);
  const auto inverse = CGP::inverse_operator(solver);
  const auto energy = CGP::reduced_operator(p.X, basis);
  const auto mass = CGP::block_operator(areas);
  Eigen::VectorXd values;
  for (int i = 0; i < iterations; ++i) {
    const Vectors y = inverse(mass(x));
    const Eigenpairs ritz = symmetric_eigenpairs(CGP::real_gram_matrix(y, energy(y)),
                                                 CGP::real_gram_matrix(y, mass(y)));
    values = ritz.values;
    for (Eigen::Index r = 0; r < x.rows(); ++r)
      for (Eigen::Index c = 0; c < x.cols(); ++c) {
        x(r, c) = Q{};
        for (Eigen::Index k = 0; k < x.cols(); ++k) x(r, c) += y(r, k) * ritz.vectors(k, c);
      }
  }
  return values;
}

double greatest_distance(const Vectors& x, const Q& constant)
{
  double distance = 0;
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    distance = std::max(distance, norm(x(i, 0) - constant));
  return distance;
}

TEST(Reduced_operator, keeps_the_disk_whose_binormals_are_kept)
{
  const Reduced_problem p = disk_with_binormals(disk(6), 1);
  Vectors x = random_block<Q>(p.X.size(), 1, 7);
  EXPECT_LE(smallest_eigenvalues(p, 6, x)[0], 1e-12);
  EXPECT_LE(greatest_distance(x, {x(0).w, 0, 0, 0}), 1e-10 * norm(x(0)));
}

TEST(Reduced_operator, turns_the_disk_by_pi_where_binormals_are_reversed)
{
  const Reduced_problem p = disk_with_binormals(disk(6), -1);
  Vectors x = random_block<Q>(p.X.size(), 1, 8);
  EXPECT_LE(smallest_eigenvalues(p, 6, x)[0], 1e-12);
  EXPECT_LE(greatest_distance(x, {0, 0, 0, x(0).z}), 1e-10 * norm(x(0)));
}

TEST(Reduced_operator, finds_the_spectrum_of_the_dirac_disk_with_second_order)
{
  // gamma = 0, and twice plus and minus the zero of J_1' [CGP 6.5.2].
  const double zero_of_derivative = 1.8411837813406593;
  double previous = 0;
  for (const int n : {4, 8, 16}) {
    const Reduced_problem p = disk_with_binormals(disk(n), 1);
    Vectors x = random_block<Q>(p.X.size(), 8, 9);
    const Eigen::VectorXd gamma = smallest_eigenvalues(p, 25, x).cwiseMax(0).cwiseSqrt();
    EXPECT_LE(gamma[0], 1e-6);
    const double error = (gamma.segment<4>(1).array() - zero_of_derivative).abs().maxCoeff();
    if (n > 4) {
      EXPECT_GT(std::log2(previous / error), 1.7);
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.01);
}

}  // namespace cgp_test::reduced_hermitian_solver_tests
