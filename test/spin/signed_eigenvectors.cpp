// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/signed_eigenvectors.h
#include <Conformal_geometry_processing/spin/signed_eigenvectors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "linear_algebra/spectral_problem.h"

namespace cgp_test::signed_eigenvectors_tests {

namespace CGP = Conformal_geometry_processing;
using Block = CGP::Block<CGP::Quaternion<double>>;

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

}  // namespace cgp_test::signed_eigenvectors_tests
