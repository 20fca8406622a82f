// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Dirac_system.h
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "spin/branch_tools.h"
#include "support/decompositions.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::dirac_system_tests {

class Dirac_system : public testing::Test {
 protected:
  using Use = CGP::internal::Dirac_system::Use;

  void set_potential(double amplitude)
  {
    system.set_potential(smooth_potential(mesh, amplitude), seconds);
  }

  CGP::Eigensolver_result smallest_pairs(int wanted) const
  {
    return smallest(system, guide_and_noise(system, one), wanted, 1e-9);
  }

  const Mesh_view mesh = icosphere(1);
  const Quaternion_vector<double> one = identity_spins(mesh);
  CGP::internal::Dirac_system system{mesh};
  CGP::internal::Dirac_evidence::Seconds seconds;
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

TEST_F(Dirac_system, has_the_smallest_pairs_of_the_dense_matrix)
{
  for (const double amplitude : {1., 3.}) {
    set_potential(amplitude);
    const CGP::Eigensolver_result r = smallest_pairs(2);
    const Eigen::MatrixXd X = real_form(dense(system.matrix()));
    const Eigen::VectorXd masses = system.areas().transpose().replicate(4, 1).reshaped(X.rows(), 1);
    const Eigen::VectorXd mu = symmetric_eigenvalues(X, masses.asDiagonal());
    ASSERT_TRUE(r.converged);
    EXPECT_NEAR(r.values[0], mu[0], 1e-12);
    EXPECT_NEAR(r.values[1], mu[4], 1e-12);
    const Eigen::MatrixXd x = real_form(r.vectors.col(0));
    EXPECT_LT((X * x - mu[0] * masses.asDiagonal() * x).norm(), 1e-7);
  }
}

TEST_F(Dirac_system, forgets_the_last_potential)
{
  set_potential(1);
  const CGP::Eigensolver_result first = smallest_pairs(1);
  set_potential(3);
  set_potential(1);
  EXPECT_TRUE(smallest_pairs(1).vectors == first.vectors);
}

TEST_F(Dirac_system, adds_up_the_seconds_of_all_potentials)
{
  set_potential(1);
  const CGP::internal::Dirac_evidence::Seconds once = seconds;
  set_potential(1);
  EXPECT_GT(once.assembly, 0);
  EXPECT_GT(once.factorization, 0);
  EXPECT_GT(seconds.assembly, once.assembly);
  EXPECT_GT(seconds.factorization, once.factorization);
}

TEST_F(Dirac_system, has_the_curvature_of_the_sphere_of_the_same_area_as_unit)
{
  const Mesh_view large = scaled_to_area(mesh, 100);
  EXPECT_NEAR(CGP::internal::Dirac_system(large).unit(), 4 * pi / 100, 1e-14);
}

TEST_F(Dirac_system, solves_with_its_matrix_and_the_shift_of_its_factor)
{
  const Quaternion_matrix b = random_quaternions(mesh.size_of_vertices(), 1);
  for (const double least : {1e-3, 1e-2}) {
    system.set_potential(smooth_potential(mesh, 1), seconds, Use::solution, least);
    EXPECT_NEAR(system.shift(), least * system.unit(), 1e-15);
    const Quaternion_vector<double> x = system.solve(b).col(0);
    Quaternion_vector<double> image = system.matrix() * x;
    for (Eigen::Index v = 0; v < x.size(); ++v)
      image[v] += (system.shift() * system.areas()[v]) * x[v];
    EXPECT_LT(greatest_difference(image, b.col(0)), 1e-11);
  }
}

TEST_F(Dirac_system, has_noise_that_depends_on_the_seed_alone)
{
  set_potential(1);
  const Quaternion_matrix a = system.noise(2, 3), b = system.noise(2, 3), c = system.noise(2, 4);
  ASSERT_EQ(a.cols(), 2);
  EXPECT_TRUE(a == b);
  EXPECT_LT(system.overlap(a.col(1), c.col(1)), 1 - 1e-6);
}

TEST_F(Dirac_system, overlaps_with_orthogonal_vectors_whose_squares_add_up_to_one)
{
  const Quaternion_vector<double> v = random_quaternions(mesh.size_of_vertices(), 3);
  const Quaternion_vector<double> w = random_quaternions(mesh.size_of_vertices(), 4);
  Quaternion_vector<double> rest = w;
  const auto along = CGP::inner_product(v, system.areas(), w) / system.squared_norm(v);
  for (Eigen::Index i = 0; i < w.size(); ++i) rest[i] -= v[i] * along;
  EXPECT_LT(system.overlap(v, rest), 1e-14);
  const double a = system.overlap(w, v), b = system.overlap(w, rest);
  EXPECT_NEAR(a * a + b * b, 1, 1e-14);
}

TEST_F(Dirac_system, overlap_is_one_for_right_factors_and_zero_for_orthogonal_vectors)
{
  const Quaternion_vector<double> a = random_quaternions(mesh.size_of_vertices(), 5);
  Quaternion_vector<double> turned = a, b = random_quaternions(mesh.size_of_vertices(), 6);
  for (auto& q : turned) q = q * Quaternion<double>{1, 2, -3, 0.5};
  EXPECT_NEAR(system.overlap(a, turned), 1, 1e-14);
  EXPECT_NEAR(system.overlap(a, b), system.overlap(b, a), 1e-14);
  EXPECT_NEAR(system.overlap_with_identity(a), system.overlap(a, one), 1e-14);
  const auto along =
      CGP::inner_product(a, system.areas(), b) / CGP::inner_product(a, system.areas(), a).w;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) b[v] -= a[v] * along;
  EXPECT_NEAR(system.overlap(a, b), 0, 1e-14);
}

TEST_F(Dirac_system, tells_which_step_of_the_solver_failed)
{
  const Mesh_view empty;
  EXPECT_THROW(CGP::internal::Dirac_system{empty}, CGP::Solver_error);
  EXPECT_THROW((void)system.noise(1, 0), CGP::Solver_error);  // not factorized yet
  EXPECT_THROW((void)system.solve(one), CGP::Solver_error);
  try {
    set_potential(std::numeric_limits<double>::quiet_NaN());
    FAIL();
  } catch (const CGP::Solver_error& error) {
    EXPECT_STREQ(error.what(), "Dirac_system: factorization of X failed: a value is not finite");
  }
}

TEST_F(Dirac_system, solves_nothing_after_its_factor_is_released_until_it_has_another)
{
  set_potential(1);
  const Quaternion_matrix before = system.solve(one);
  system.release();
  EXPECT_THROW((void)system.solve(one), CGP::Solver_error);
  set_potential(1);
  EXPECT_TRUE(system.solve(one) == before);
}

TEST_F(Dirac_system, is_shifted_more_where_rounding_makes_it_indefinite_but_not_forever)
{
  const double four_pi = 4 * std::acos(-1.);  // the sum of the shifts by unit()
  const Curvature_potential rho = smooth_potential(mesh, 1);
  CGP::internal::Dirac_system timid(mesh, {}, "test", Timid_solver_traits());
  Timid_solver_traits::enough = 0.005 * four_pi;
  timid.set_potential(rho, seconds);
  EXPECT_EQ(Timid_solver_traits::factorizations, 2);
  EXPECT_NEAR(timid.shift(), 1e-2 * timid.unit(), 1e-15);
  const auto r = smallest(timid, guide_and_noise(timid, one), 1, 1e-9);
  set_potential(1);
  EXPECT_NEAR(r.values[0], smallest_pairs(1).values[0], 1e-12);

  Timid_solver_traits::enough = four_pi;
  EXPECT_THROW(timid.set_potential(rho, seconds), CGP::Solver_error);
}

// A shift towards the smallest eigenvalue makes a better preconditioner, unless it is beyond it.
TEST_F(Dirac_system, is_shifted_below_zero_as_long_as_it_stays_definite)
{
  const Curvature_potential rho = smooth_potential(mesh, 1);
  set_potential(1);
  const double mu = smallest_pairs(1).values[0] / system.unit();
  ASSERT_GT(mu, 1e-3);
  system.set_potential(rho, seconds, Use::preconditioner, -mu / 2);
  EXPECT_NEAR(system.shift(), -mu / 2 * system.unit(), 1e-15);
  system.set_potential(rho, seconds, Use::preconditioner, -2 * mu);
  EXPECT_NEAR(system.shift(), 1e-3 * system.unit(), 1e-15);
}

}  // namespace cgp_test::dirac_system_tests
