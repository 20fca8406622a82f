// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Dirac_eigenproblem.h
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>
#include <Conformal_geometry_processing/templates.h>

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/dense.h"
#include "support/meshes.h"

namespace {

using namespace cgp_test;
namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

class Dirac_eigenproblem : public testing::Test {
 protected:
  void set_potential(double amplitude)
  {
    problem.set_potential(
        Curvature_potential::on_vertices(amplitude * rho_of_section_3_on_vertices(mesh)), seconds);
  }

  Quaternion_vector<double> one() const
  {
    return Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0, 0, 0});
  }

  CGP::Eigensolver_result smallest(int wanted) const
  {
    return problem.smallest(problem.start(one(), 0), wanted, 1e-9, 200, CGP::Always_go_further());
  }

  const Mesh_view mesh = icosphere(1);
  CGP::Dirac_eigenproblem<> problem{mesh};
  CGP::Dirac_solution::Seconds seconds;
};

/// finds matrices indefinite until they are shifted by so much, in multiples of the vertex areas
struct Timid_solver_traits {
  static inline double enough = 0;
  static inline int factorizations = 0;

  template <class Scalar>
  struct Solver : CGP::Supernodal_cholesky<Scalar> {
    CGP::Solver_status factorize(const CGP::Hermitian_sparse_matrix<Scalar>& A,
                                 const Eigen::VectorXd& shift)
    {
      ++factorizations;
      if (shift.sum() < enough) return CGP::Solver_status::not_positive_definite;
      return CGP::Supernodal_cholesky<Scalar>::factorize(A, shift);
    }
  };
};

}  // namespace

TEST_F(Dirac_eigenproblem, finds_the_smallest_pairs_of_the_dense_matrix)
{
  for (const double amplitude : {1., 3.}) {
    set_potential(amplitude);
    const CGP::Eigensolver_result r = smallest(2);
    const Eigen::MatrixXd X = real_form(dense(problem.matrix()));
    const Eigen::VectorXd masses =
        problem.areas().transpose().replicate(4, 1).reshaped(X.rows(), 1);
    const Eigen::VectorXd mu = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                                   X, Eigen::MatrixXd(masses.asDiagonal()))
                                   .eigenvalues();
    ASSERT_TRUE(r.converged);
    EXPECT_NEAR(r.values[0], mu[0], 1e-12);
    EXPECT_NEAR(r.values[1], mu[4], 1e-12);
    const Eigen::MatrixXd x = real_form(r.vectors.col(0));
    EXPECT_LT((X * x - mu[0] * masses.asDiagonal() * x).norm(), 1e-7);
  }
}

TEST_F(Dirac_eigenproblem, forgets_the_last_potential)
{
  set_potential(1);
  const CGP::Eigensolver_result first = smallest(1);
  set_potential(3);
  set_potential(1);
  EXPECT_TRUE(smallest(1).vectors == first.vectors);
}

TEST_F(Dirac_eigenproblem, adds_up_the_seconds_of_all_potentials)
{
  set_potential(1);
  const CGP::Dirac_solution::Seconds once = seconds;
  set_potential(1);
  EXPECT_GT(once.assembly, 0);
  EXPECT_GT(once.factorization, 0);
  EXPECT_GT(seconds.assembly, once.assembly);
  EXPECT_GT(seconds.factorization, once.factorization);
}

TEST_F(Dirac_eigenproblem, has_the_curvature_of_the_sphere_of_the_same_area_as_unit)
{
  const Mesh_view large = scaled_to_area(mesh, 100);
  EXPECT_NEAR(CGP::Dirac_eigenproblem<>(large).unit(), 4 * pi / 100, 1e-14);
}

TEST_F(Dirac_eigenproblem, tells_the_same_errors_in_all_units_of_length)
{
  const Eigen::VectorXd rho = rho_of_section_3_on_vertices(mesh);
  const auto after_two_iterations = [&](double scale) {
    const Mesh_view large = scaled(mesh, scale);
    CGP::Dirac_eigenproblem<> eigenproblem(large);
    eigenproblem.set_potential(Curvature_potential::on_vertices(rho / scale), seconds);
    const auto start = eigenproblem.start(one(), 0);
    return eigenproblem.smallest(start, 2, 1e-9, 2, CGP::Always_go_further());
  };
  const CGP::Eigensolver_result a = after_two_iterations(1), b = after_two_iterations(1024);
  EXPECT_GT(a.estimates.maxCoeff(), 1e-6);
  EXPECT_LT((a.estimates - b.estimates).norm(), 1e-6 * a.estimates.norm());
}

TEST_F(Dirac_eigenproblem, starts_with_the_guide_and_noise_that_depends_on_the_seed_alone)
{
  set_potential(1);
  const Quaternion_matrix a = problem.start(one(), 3), b = problem.start(one(), 3);
  const Quaternion_matrix c = problem.start(one(), 4);
  ASSERT_EQ(a.cols(), 2);
  EXPECT_EQ(Quaternion_vector<double>(a.col(0)), one());
  EXPECT_TRUE(a == b);
  EXPECT_LT(problem.overlap(a.col(1), c.col(1)), 1 - 1e-6);
}

TEST_F(Dirac_eigenproblem, finds_the_companion_in_a_mixture)
{
  const auto rho = Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
  problem.set_potential(rho, seconds);
  const CGP::Eigensolver_result r = smallest(2);
  const Quaternion_matrix pure =
      CGP::rayleigh_ritz_of_dirac(r.vectors, CGP::dirac_forms(mesh, rho, r.vectors));
  const Quaternion_vector<double> u = pure.col(0), v = pure.col(1);
  for (const double angle : {0.1, 0.5}) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Quaternion_vector<double> mixed = c * u + s * v, other = c * v - s * u;
    Quaternion_matrix companions =
        problem.companion(mixed, CGP::apply_dirac_form(mesh, rho, mixed));
    double before = 0.95;
    for (int k = 1; k <= 3; ++k) {
      ASSERT_EQ(companions.cols(), k);
      const Quaternion_matrix both = problem.with_lowest(mixed, companions);
      EXPECT_EQ(Quaternion_vector<double>(both.col(0)), mixed);
      EXPECT_LT(problem.overlap(both.col(0), both.col(1)), 1e-12);
      EXPECT_GT(problem.overlap(both.col(1), other), before);
      before = problem.overlap(both.col(1), other) - 0.01;
      problem.add_companion(mixed, companions);
    }
  }
}

TEST_F(Dirac_eigenproblem, has_the_vector_of_smallest_energy_among_companions)
{
  set_potential(1);
  const CGP::Eigensolver_result r = smallest(2);
  const Quaternion_vector<double> v = r.vectors.col(0), w = r.vectors.col(1);
  Quaternion_matrix companions(v.size(), 2);
  companions << w + random_quaternions(mesh.size_of_vertices(), 2),
      2. * w - random_quaternions(mesh.size_of_vertices(), 2);
  EXPECT_NEAR(problem.overlap(problem.with_lowest(v, companions).col(1), w), 1, 1e-12);
  companions.setConstant(Quaternion<double>{});
  EXPECT_EQ(problem.with_lowest(v, companions).cols(), 1);
}

TEST_F(Dirac_eigenproblem, splits_a_guide_into_a_vector_and_the_rest)
{
  const Quaternion_vector<double> v = random_quaternions(mesh.size_of_vertices(), 3);
  const Quaternion_vector<double> w = random_quaternions(mesh.size_of_vertices(), 4);
  const Quaternion_matrix both = problem.with_rest(v, w);
  EXPECT_EQ(Quaternion_vector<double>(both.col(0)), v);
  EXPECT_LT(problem.overlap(v, both.col(1)), 1e-14);
  const double a = problem.overlap(w, v), b = problem.overlap(w, both.col(1));
  EXPECT_NEAR(a * a + b * b, 1, 1e-14);
}

TEST_F(Dirac_eigenproblem, overlap_is_one_for_right_factors_and_zero_for_orthogonal_vectors)
{
  const Quaternion_vector<double> a = random_quaternions(mesh.size_of_vertices(), 5);
  Quaternion_vector<double> turned = a, b = random_quaternions(mesh.size_of_vertices(), 6);
  for (auto& q : turned) q = q * Quaternion<double>{1, 2, -3, 0.5};
  EXPECT_NEAR(problem.overlap(a, turned), 1, 1e-14);
  EXPECT_NEAR(problem.overlap(a, b), problem.overlap(b, a), 1e-14);
  const auto along =
      CGP::inner_product(a, problem.areas(), b) / CGP::inner_product(a, problem.areas(), a).w;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) b[v] -= a[v] * along;
  EXPECT_NEAR(problem.overlap(a, b), 0, 1e-14);
}

TEST_F(Dirac_eigenproblem, tells_which_step_of_the_solver_failed)
{
  const Mesh_view empty;
  EXPECT_THROW(CGP::Dirac_eigenproblem<>{empty}, CGP::Solver_error);
  EXPECT_THROW((void)problem.start(one(), 0), CGP::Solver_error);  // not factorized yet
  EXPECT_THROW((void)problem.companion(one(), one()), CGP::Solver_error);
  try {
    set_potential(std::numeric_limits<double>::quiet_NaN());
    FAIL();
  } catch (const CGP::Solver_error& error) {
    EXPECT_STREQ(error.what(), "Dirac_equation: factorization of X failed: a value is not finite");
  }
}

TEST_F(Dirac_eigenproblem, is_shifted_more_where_rounding_makes_it_indefinite_but_not_forever)
{
  const double four_pi = 4 * std::acos(-1.);  // the sum of the shifts by unit()
  const auto rho = Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
  CGP::Dirac_eigenproblem<Timid_solver_traits> timid(mesh);
  Timid_solver_traits::enough = 0.005 * four_pi;
  timid.set_potential(rho, seconds);
  EXPECT_EQ(Timid_solver_traits::factorizations, 2);
  const auto r = timid.smallest(timid.start(one(), 0), 1, 1e-9, 200, CGP::Always_go_further());
  set_potential(1);
  EXPECT_NEAR(r.values[0], smallest(1).values[0], 1e-12);

  Timid_solver_traits::enough = four_pi;
  EXPECT_THROW(timid.set_potential(rho, seconds), CGP::Solver_error);
}
