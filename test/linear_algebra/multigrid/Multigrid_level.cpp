// Tests include/Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_level.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_level.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "linear_algebra/multigrid_tools.h"

namespace cgp_test::multigrid_level_tests {

template <class Scalar>
class Multigrid_level : public testing::Test {
 protected:
  static constexpr int n = 80, planes = planes_of<Scalar>, columns = columns_of<Scalar>;
  using Level = CGP::internal::Multigrid_level<Entry_of<Scalar>>;

  Multigrid_level()
  {
    for (int i = 0; i < n; ++i)
      for (int q = 0; q < 4; ++q) level.vector(i)[q] = static_cast<float>(lane<Scalar>(b, i, q));
  }

  static CGP::internal::Prolongation prolongation(const Pattern& pattern)
  {
    const CGP::internal::Connection_graph g =
        CGP::strong_connections(random_laplacian(pattern, 2), 0);
    return CGP::smoothed_prolongation(g, CGP::aggregate(g), .8);
  }

  Eigen::MatrixXd vector()
  {
    Eigen::MatrixXd x(b.rows(), b.cols());
    for (int i = 0; i < n; ++i)
      for (int q = 0; q < 4; ++q) lane<Scalar>(x, i, q) = static_cast<double>(level.vector(i)[q]);
    return x;
  }

  // D + L^H in real form. Diagonal blocks are multiples of the identity.
  Eigen::MatrixXd upper() const { return A.template triangularView<Eigen::Upper>(); }

  Pattern pattern = random_pattern(n, 1);
  CGP::Hermitian_sparse_matrix<Scalar> matrix = random_definite<Scalar>(pattern, 3);
  Level level{single(matrix), prolongation(pattern)};
  Eigen::MatrixXd A = real_form(matrix), P = real_form(level.prolongation(), planes);
  Eigen::MatrixXd b = real_columns(random_block<Scalar>(n, columns, 4));
};
using Scalars = testing::Types<double, Quaternion<double>>;
TYPED_TEST_SUITE(Multigrid_level, Scalars);

TYPED_TEST(Multigrid_level, smooths_by_backward_gauss_seidel_first)
{
  this->level.smooth_first();
  EXPECT_LT(relative_difference(this->vector(), this->upper().inverse() * this->b), 1e-6);
}

TYPED_TEST(Multigrid_level, restricts_the_residual)
{
  this->level.smooth_first();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(this->P.cols(), this->b.cols());
  this->level.restrict_residual([&](int I, const auto& part) {
    for (int q = 0; q < 4; ++q) lane<TypeParam>(sum, I, q) += static_cast<double>(part[q]);
  });
  const Eigen::MatrixXd x = this->upper().inverse() * this->b;
  EXPECT_LT(relative_difference(sum, this->P.transpose() * (this->b - this->A * x)), 1e-6);
}

TYPED_TEST(Multigrid_level, corrects_and_smooths_by_forward_gauss_seidel)
{
  const int coarse_size = this->level.prolongation().coarse_size;
  Eigen::MatrixXd c = real_columns(random_block<TypeParam>(coarse_size, columns_of<TypeParam>, 5));
  std::vector<float> correction;
  for (int I = 0; I < coarse_size; ++I)
    for (int q = 0; q < 4; ++q) correction.push_back(static_cast<float>(lane<TypeParam>(c, I, q)));
  this->level.smooth_first();
  this->level.correct_and_smooth([&](int I) { return correction.data() + 4 * I; });
  const Eigen::MatrixXd x = this->upper().inverse() * this->b + this->P * c;
  const Eigen::MatrixXd lower = this->upper().transpose();
  const Eigen::MatrixXd expected = x + lower.inverse() * (this->b - this->A * x);
  EXPECT_LT(relative_difference(this->vector(), expected), 1e-6);
}

TYPED_TEST(Multigrid_level, tells_its_memory)
{
  const double entries = this->pattern->size_of_entries();
  const double vectors = 8 * this->n;
  EXPECT_EQ(static_cast<double>(this->level.bytes()),
            4 * (entries * planes_of<TypeParam> + vectors) +
                static_cast<double>(this->level.prolongation().bytes()));
  EXPECT_EQ(this->level.size(), this->n);
  EXPECT_EQ(&this->level.matrix().pattern(), this->pattern.get());
}

}  // namespace cgp_test::multigrid_level_tests
