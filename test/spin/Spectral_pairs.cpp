// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Dirac_spectrum.h
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/spectral_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cgp_test::spectral_pairs_tests {

namespace CGP = Conformal_geometry_processing;
using Block = CGP::Block<CGP::Quaternion<double>>;

namespace internal = Conformal_geometry_processing::internal;

/// quotients .1, -.5, 1, -2 with the squared errors .01, .04, .02, .5
internal::Spectral_pairs four_pairs(double reach)
{
  internal::Spectral_pairs p;
  p.quotients = Eigen::Vector4d(.1, -.5, 1, -2);
  p.energies = p.quotients.array().square() + Eigen::Array4d(.01, .04, .02, .5);
  p.squared_images = Eigen::Vector4d::Constant(9);
  p.of_pencil = p.residuals = Eigen::Vector4d::Zero();
  p.vectors.resize(2, 4);
  p.reach = reach;
  return p;
}

TEST(Spectral_pairs, tell_the_greatest_squared_error_of_the_first)
{
  EXPECT_NEAR(internal::squared_error(four_pairs(9), 1), .01, 1e-15);
  EXPECT_NEAR(internal::squared_error(four_pairs(9), 3), .04, 1e-15);
  EXPECT_NEAR(internal::squared_error(four_pairs(9), 9), .5, 1e-15);
  internal::Spectral_pairs exact = four_pairs(9);
  exact.energies = exact.quotients.array().square() - 1e-3;  // up to rounding and lumping
  EXPECT_EQ(internal::squared_error(exact, 4), 0);
}

TEST(Spectral_pairs, are_complete_as_far_as_their_errors_leave_of_the_reach)
{
  EXPECT_NEAR(internal::needed_reach(four_pairs(9), 3), 1.08, 1e-15);
  EXPECT_TRUE(internal::is_window_complete(four_pairs(1.09), 3));
  EXPECT_FALSE(internal::is_window_complete(four_pairs(1.07), 3));
  EXPECT_FALSE(internal::is_window_complete(four_pairs(9), 5));
  EXPECT_NEAR(internal::complete_radius(four_pairs(2.08), 4), std::sqrt(2.), 1e-12);
  EXPECT_NEAR(internal::complete_radius(four_pairs(.5), 4), std::sqrt(.42), 1e-12);
  EXPECT_EQ(internal::complete_radius(four_pairs(.02), 4), 0);
}

TEST(Spectral_pairs, are_not_complete_beyond_the_first_that_is_not_listed)
{
  EXPECT_EQ(internal::complete_radius(four_pairs(9), 3), 2);
  EXPECT_NEAR(internal::complete_radius(four_pairs(9), 4), std::sqrt(8.), 1e-12);
  const double all = std::numeric_limits<double>::infinity();
  EXPECT_EQ(internal::complete_radius(four_pairs(all), 4), all);
}

TEST(Spectral_pairs, are_those_that_the_mesh_resolves_nearest_first)
{
  internal::Spectral_pairs p = four_pairs(9);
  p.quotients = Eigen::Vector4d(-2, .1, 1, -.5);
  p.energies = Eigen::Vector4d(4.5, .02, 5, .29);
  p.squared_images = Eigen::Vector4d(9, 0.03, 7.9, 1);  // the third errs by 4 > 7.9 / 2
  p.residuals = Eigen::Vector4d(0, 1, 2, 3);
  const internal::Spectral_pairs r = internal::resolved_nearest_first(p);
  EXPECT_EQ(r.quotients, Eigen::Vector3d(.1, -.5, -2));
  EXPECT_EQ(r.residuals, Eigen::Vector3d(1, 3, 0));
  EXPECT_EQ(r.reach, 5);
  EXPECT_TRUE(r.is_limited_by_mesh);
  const internal::Spectral_pairs again = internal::resolved_nearest_first(r);
  EXPECT_EQ(again.reach, 5);
  EXPECT_FALSE(again.is_limited_by_mesh);
}

TEST(Spectral_pairs, resolve_what_does_not_oscillate_from_edge_to_edge_though_it_errs)
{
  internal::Spectral_pairs p = four_pairs(9);
  p.squared_images[0] = p.energies[0] = 1;  // and the quotient .1
  EXPECT_EQ(internal::resolved_nearest_first(p).size(), 3);
  p.slow_energy = 1;
  EXPECT_EQ(internal::resolved_nearest_first(p).size(), 4);
}

// On a mesh whose vertices have two colors, what changes its sign with them has averages of zero.
TEST(Spectral_pairs, do_not_resolve_what_averaging_cancels)
{
  internal::Spectral_pairs p = four_pairs(9);
  p.quotients[3] = -1e10;
  const internal::Spectral_pairs r = internal::resolved_nearest_first(p);
  EXPECT_EQ(r.size(), 3);
  EXPECT_EQ(r.reach, p.energies[3]);
  EXPECT_TRUE(r.is_limited_by_mesh);
}

TEST(Spectral_pairs, resolve_constants_whose_image_is_zero)
{
  internal::Spectral_pairs p = four_pairs(9);
  p.energies[2] = 1 + 1e-12;
  p.squared_images[2] = 0;  // with a slow energy of zero too
  EXPECT_EQ(internal::resolved_nearest_first(p).size(), 4);
}

TEST(Spectral_subspace_size, exceeds_the_count_and_grows_with_the_missing_energy)
{
  EXPECT_EQ(internal::first_subspace_size(12), 22);
  EXPECT_EQ(internal::largest_subspace_size(12), 140);
  EXPECT_EQ(internal::next_subspace_size(20, 99, four_pairs(1.08 / 1.5), 3), 33);
  EXPECT_EQ(internal::next_subspace_size(20, 99, four_pairs(1), 3), 25);
  EXPECT_EQ(internal::next_subspace_size(20, 99, four_pairs(.1), 3), 40);
  EXPECT_EQ(internal::next_subspace_size(20, 99, four_pairs(9), 5), 40);  // too few
  EXPECT_EQ(internal::next_subspace_size(20, 30, four_pairs(9), 5), 30);
}

/// K with eigenvalues of both signs, and N = K M^-1 K + error M, all with masses M
class Signed_eigenvectors : public testing::Test {
 protected:
  static constexpr double error = 0.01;

  static Eigen::VectorXd squares(const Eigen::VectorXd& values)
  {
    return (values.array().square() + error).matrix();
  }

  Signed_eigenvectors()
  {
    form.K = signs.k();
    form.N = square.k();
    form.solve = square.inverse();
  }

  /// the eigenvectors of K, where those of opposite sign are mixed
  Block mixed() const
  {
    Block v = signs.vectors();
    for (Eigen::Index j = 0; j + 1 < v.cols(); ++j)
      if (values[j] == -values[j + 1]) {
        const Block pair = v.middleCols(j, 2);
        Block rotation(2, 2);
        rotation << Quaternion<double>{.8, 0, 0, 0}, Quaternion<double>{0, .6, 0, 0},
            Quaternion<double>{0, .6, 0, 0}, Quaternion<double>{.8, 0, 0, 0};
        v.middleCols(j, 2) = CGP::combination(pair, rotation);
      }
    return v;
  }

  /// the first eigenpairs of M x = theta N x
  CGP::internal::Krylov_result first(Eigen::Index count, const Eigen::VectorXd& squares) const
  {
    CGP::internal::Krylov_result r;
    r.values = squares.head(count).cwiseInverse();
    r.vectors = mixed().leftCols(count);
    r.residuals = Eigen::VectorXd::LinSpaced(count, 1e-9, 1e-9 * static_cast<double>(count));
    for (Eigen::Index j = 0; j < count; ++j)
      CGP::scale_column(r.vectors, j, std::sqrt(r.values[j]));
    return r;
  }

  CGP::internal::Krylov_result first(Eigen::Index count) const
  {
    return first(count, squares(values));
  }

  /// N with the squares as eigenvalues of the mixed vectors
  void set_square(const Eigen::VectorXd& squares)
  {
    const Block v = mixed(), duals = signs.n()(v);
    const auto spectral = [](const Block& outer, Block c, const Eigen::VectorXd& factors) {
      for (Eigen::Index i = 0; i < c.rows(); ++i)
        for (Eigen::Index j = 0; j < c.cols(); ++j) c(i, j) *= factors[i];
      return CGP::combination(outer, c);
    };
    form.N = [=](const Block& x) { return spectral(duals, CGP::gram_matrix(duals, x), squares); };
    form.solve = [=](const Block& x) {
      return spectral(v, CGP::gram_matrix(v, x), squares.cwiseInverse());
    };
  }

  void expect_separated(const CGP::internal::Signed_eigenvectors& r) const
  {
    ASSERT_EQ(r.vectors.cols(), 8);
    const Block S = CGP::gram_matrix(r.vectors, form.K(r.vectors));
    std::vector<double> found;
    for (Eigen::Index j = 0; j < 8; ++j) found.push_back(S(j, j).w);
    std::vector<double> expected(values.begin(), values.begin() + 8);
    std::sort(expected.begin(), expected.end());
    for (std::size_t j = 0; j < 8; ++j) EXPECT_NEAR(found[j], expected[j], 1e-11);
    const Block gram = CGP::gram_matrix(r.vectors, signs.n()(r.vectors));
    EXPECT_LT((real_form(gram) - Eigen::MatrixXd::Identity(32, 32)).norm(), 1e-11);
  }

  const Eigen::VectorXd values =
      (Eigen::VectorXd(12) << .05, 1, -1, 2, 2.5, 3, -3, 4, 5, -6, 7, 8).finished();
  const Spectral_problem signs{values}, square{squares(values)};
  CGP::internal::Pencil form;
};

TEST_F(Signed_eigenvectors, are_separated_and_orthonormal)
{
  const auto r = CGP::signed_eigenvectors(form, first(8));
  expect_separated(r);
  EXPECT_NEAR(r.reach, 16 + error, 1e-10);
  EXPECT_LT(signs.sine(r.vectors.col(2), 1, 0), 1e-9);  // of .05, after -3 and -1
}

// On coarse meshes the squares of 1 and -1 differ by more than a factor of two.
TEST_F(Signed_eigenvectors, are_separated_where_errors_tell_their_squares_apart)
{
  Eigen::VectorXd with_errors = squares(values);
  with_errors[1] = 1.2;
  with_errors[2] = 4;
  set_square(with_errors);
  expect_separated(CGP::signed_eigenvectors(form, first(8, with_errors)));
}

TEST_F(Signed_eigenvectors, are_left_out_where_the_opposite_ones_are_missing)
{
  const auto r = CGP::signed_eigenvectors(form, first(6));  // cuts between 3 and -3
  ASSERT_EQ(r.vectors.cols(), 5);
  EXPECT_NEAR(r.reach, 9 + error, 1e-10);
  EXPECT_LT(signs.sine(r.vectors, 5, 0), 1e-9);
}

TEST_F(Signed_eigenvectors, combine_the_residuals_like_the_vectors)
{
  const auto r = CGP::signed_eigenvectors(form, first(3));
  ASSERT_EQ(r.vectors.cols(), 3);
  EXPECT_NEAR(r.residuals[1], 1e-9, 1e-14);  // of .05, which is not mixed
  // -1 is .6 of the second and .8 of the third
  EXPECT_NEAR(r.residuals[0], 1e-9 * std::hypot(.6 * 2, .8 * 3), 1e-13);
  EXPECT_NEAR(r.residuals[2], 1e-9 * std::hypot(.8 * 2, .6 * 3), 1e-13);
}

}  // namespace cgp_test::spectral_pairs_tests
