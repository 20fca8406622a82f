// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Dirac_search.h
#include <Conformal_geometry_processing/spin/Dirac_search.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>

#include "spin/branch_tools.h"
#include "support/dense.h"

namespace {

using namespace cgp_test;

using Search =
    CGP::internal::Dirac_search<CGP::Default_solver_traits, CGP::Lobpcg_eigensolver_traits>;

class Dirac_search : public testing::Test {
 protected:
  Search search_for(const Curvature_potential& rho)
  {
    CGP::internal::Dirac_evidence::Seconds seconds;
    system.set_potential(rho, seconds);
    return Search(system, rho, one, options, always);
  }

  double overlap(const Search& search, Eigen::Index column) const
  {
    return system.overlap(const_cast<Search&>(search).result().vectors.col(column), one);
  }

  explicit Dirac_search(int level = 3) : sphere(icosphere(level)) {}

  const Mesh_view sphere;
  CGP::internal::Dirac_system<> system{sphere};
  const Quaternion_vector<double> one = identity_spins(sphere);
  CGP::Dirac_options options;
  const CGP::internal::Go_further always = CGP::internal::Always_go_further();
};

/// The eigenvalue -2 of the normal and that of the identity become nearly opposite
class Dirac_search_of_a_mixture : public Dirac_search {
 protected:
  Dirac_search_of_a_mixture() : Dirac_search(2) {}

  const Curvature_potential rho = scaled(smooth_potential(sphere, 1), 1, -1.01);
};

}  // namespace

TEST_F(Dirac_search, takes_one_column_where_it_is_on_the_branch)
{
  const Curvature_potential rho = smooth_potential(sphere, 1);
  Search search = search_for(rho);
  search.run(one);
  EXPECT_FALSE(search.is_mixed());
  EXPECT_TRUE(search.result().converged);
  EXPECT_EQ(search.result().vectors.cols(), 1);
  EXPECT_GT(overlap(search, 0), Search::same_branch);
}

// The guide is half the identity and half the normal: no vector orthogonal to either is nearer.
TEST_F(Dirac_search, takes_one_column_where_no_other_vector_can_be_on_the_branch)
{
  const Curvature_potential rho = smooth_potential(sphere, 0.1);
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.set_potential(rho, seconds);
  const Quaternion_vector<double> guide =
      std::sqrt(.5) * (one + imaginary_columns(sphere.positions()));
  Search search(system, rho, guide, options, always);
  search.run(one);
  ASSERT_FALSE(search.is_mixed());
  EXPECT_LT(system.overlap(search.result().vectors.col(0), guide), Search::same_branch);
  EXPECT_EQ(search.result().vectors.cols(), 1);
}

// The eigenvalue of the normal is nearest to zero, followed by that of the identity.
TEST_F(Dirac_search, takes_two_columns_where_the_smallest_leaves_room_for_a_nearer_one)
{
  const Curvature_potential rho = scaled(smooth_potential(sphere, 0.3), 1, -1.3);
  Search search = search_for(rho);
  search.run(imaginary_columns(sphere.positions()));
  ASSERT_FALSE(search.is_mixed());
  ASSERT_EQ(search.result().vectors.cols(), 2);
  EXPECT_LT(overlap(search, 0), 0.1);
  EXPECT_GT(overlap(search, 1), 0.9);
  EXPECT_LE(search.result().estimates[1], options.tolerance);
}

TEST_F(Dirac_search_of_a_mixture, finds_two_vectors_that_the_signed_form_separates)
{
  Search search = search_for(rho);
  search.run(one);
  ASSERT_TRUE(search.is_mixed());
  EXPECT_FALSE(search.is_cancelled());
  const CGP::internal::Dirac_forms forms = CGP::dirac_forms(sphere, rho, search.mixture());
  const Quaternion_matrix pure = CGP::rayleigh_ritz_of_dirac(search.mixture(), forms);
  const Quaternion_vector<double> u = pure.col(0), v = pure.col(1);
  EXPECT_GT(system.overlap(u, imaginary_columns(sphere.positions())), 0.9);
  EXPECT_GT(system.overlap(v, one), 0.9);
  const auto values = CGP::signed_eigenvalues(forms);
  EXPECT_NEAR(CGP::dirac_quotient(sphere, rho, u), values[0], 5e-3);
  EXPECT_NEAR(CGP::dirac_quotient(sphere, rho, v), values[1], 5e-3);
}

// The companion is the other mixture of the same two eigenvectors.
TEST_F(Dirac_search_of_a_mixture, finds_the_companion_of_its_vector)
{
  Search search = search_for(rho);
  search.run(one);
  ASSERT_TRUE(search.is_mixed());
  const Quaternion_vector<double> v = search.mixture().col(0), w = search.mixture().col(1);
  EXPECT_LT(system.overlap(v, w), 1e-12);
  const CGP::Eigensolver_result r = smallest(system, guide_and_noise(system, one), 2, 1e-9);
  ASSERT_TRUE(r.converged);
  for (const Quaternion_vector<double>& mixed : {v, w})
    EXPECT_GT(std::hypot(system.overlap(mixed, r.vectors.col(0)),
                         system.overlap(mixed, r.vectors.col(1))),
              0.95);
  const double energy = CGP::inner_product(w, system.matrix() * w).w / system.squared_norm(w);
  EXPECT_NEAR(energy, r.values[1], 0.05 * r.values[1]);
}

// The identity solves the equation exactly for constant rho, and its companion is zero.
TEST_F(Dirac_search, sees_no_mixture_in_a_vector_without_companion)
{
  const Curvature_potential rho = scaled(smooth_potential(sphere, 0), 1, -1);
  Search search = search_for(rho);
  search.run(one);
  EXPECT_FALSE(search.is_mixed());
  EXPECT_TRUE(search.result().converged);
  EXPECT_EQ(search.result().vectors.cols(), 1);
  EXPECT_NEAR(overlap(search, 0), 1, 1e-12);
}

TEST(Dirac_search_on_a_sphere, tells_the_same_errors_in_all_units_of_length)
{
  const Mesh_view sphere = icosphere(1);
  CGP::Dirac_options options;
  options.max_iterations = 2;
  const CGP::internal::Go_further always = CGP::internal::Always_go_further();
  const auto after_two_iterations = [&](double scale) {
    const Mesh_view large = scaled(sphere, scale);
    CGP::internal::Dirac_system<> system(large);
    CGP::internal::Dirac_evidence::Seconds seconds;
    const Curvature_potential rho = smooth_potential(sphere, 1 / scale);
    system.set_potential(rho, seconds);
    const Quaternion_vector<double> one = identity_spins(large);
    Search search(system, rho, one, options, always);
    search.run(one);
    return search.result().estimates;
  };
  const Eigen::VectorXd a = after_two_iterations(1), b = after_two_iterations(1024);
  EXPECT_GT(a.maxCoeff(), 1e-6);
  EXPECT_LT((a - b).norm(), 1e-6 * a.norm());
}

TEST(Dirac_search_on_bumps, finds_a_mixture_before_its_vector_has_converged)
{
  const Mesh_view bumps = mapped(icosphere(2), [](const Eigen::Vector3d& p) {
    const double height = std::sin(7 * p.x() + 1) * std::sin(6 * p.y() + 2) + std::sin(9 * p.z());
    return Eigen::Vector3d((1 + 0.15 * height) * p.cwiseProduct(Eigen::Vector3d(1, 0.7, 0.5)));
  });
  const Mesh_view mesh = scaled_to_area(bumps, 4 * pi);
  CGP::internal::Dirac_system<> system(mesh);
  const Curvature_potential rho = smooth_potential(mesh, 2);
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.set_potential(rho, seconds);
  const Quaternion_vector<double> guide = identity_spins(mesh);
  const CGP::internal::Go_further always = CGP::internal::Always_go_further();
  Search search(system, rho, guide, CGP::Dirac_options(), always);
  search.run(guide);
  ASSERT_TRUE(search.is_mixed());
  EXPECT_FALSE(search.result().converged);
  EXPECT_EQ(search.result().vectors.cols(), 1);
}

TEST_F(Dirac_search_of_a_mixture, with_a_separated_vector_needs_no_companion)
{
  Search mixed = search_for(rho);
  mixed.run(one);
  const CGP::internal::Dirac_forms forms = CGP::dirac_forms(sphere, rho, mixed.mixture());
  const auto values = CGP::signed_eigenvalues(forms);
  const Quaternion_vector<double> start =
      CGP::rayleigh_ritz_of_dirac(mixed.mixture(), forms).col(1);
  const Curvature_potential shifted = scaled(rho, 1, values[1]);
  Search search = search_for(shifted);
  search.run(start, values[1] - values[0]);
  EXPECT_FALSE(search.is_mixed());
  EXPECT_TRUE(search.result().converged);
  EXPECT_GT(system.overlap(search.result().vectors.col(0), start), 0.99);
}

// Said to be separated, the vector of the mixture is not believed.
TEST_F(Dirac_search_of_a_mixture, finds_a_mixture_that_is_said_to_be_separated)
{
  Search search = search_for(rho);
  search.run(one, 2);
  EXPECT_TRUE(search.is_mixed());
}

TEST_F(Dirac_search, keeps_to_the_iterations_allowed)
{
  for (const double amplitude : {1., 3., 5.})
    for (options.max_iterations = 1; options.max_iterations < 6; ++options.max_iterations) {
      const Curvature_potential rho = smooth_potential(sphere, amplitude);
      Search search = search_for(rho);
      search.run(one);
      EXPECT_LE(search.iterations(), options.max_iterations);
      EXPECT_GE(search.result().vectors.cols(), 1);
    }
}

TEST_F(Dirac_search, is_cancelled_by_the_caller_only)
{
  const CGP::internal::Go_further stop = [](const CGP::Eigensolver_progress& p) {
    return p.iteration < 1;
  };
  const Curvature_potential rho = smooth_potential(sphere, 1);
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.set_potential(rho, seconds);
  Search search(system, rho, one, options, stop);
  search.run(one);
  EXPECT_TRUE(search.is_cancelled());
}
