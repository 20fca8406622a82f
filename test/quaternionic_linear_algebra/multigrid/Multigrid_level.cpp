// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/multigrid/Multigrid_level.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "quaternionic_linear_algebra/multigrid_tools.h"
#include "support/random.h"

namespace cgp_test::multigrid_level_tests {

namespace CGP = Conformal_geometry_processing;

template <class Real>
class Vertex_lanes : public testing::Test {
 protected:
  using Lanes = CGP::internal::Vertex_lanes<Real>;
  using Register = typename Lanes::Register;
  using Quaternionic = CGP::Quaternion<Real>;

  static void load(const Quaternionic& q, Register& v) { Lanes::load(&q.w, v); }

  static void expect_equal(const Register& v, const Quaternionic& q)
  {
    Quaternionic stored;
    Lanes::store(&stored.w, v);
    EXPECT_LT(norm(stored - q), 8 * std::numeric_limits<Real>::epsilon());
  }

  Quaternionic random_quaternion()
  {
    const Quaternion<double> q = random.quaternion();
    return {Real(q.w), Real(q.x), Real(q.y), Real(q.z)};
  }

  Random random{1};
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Vertex_lanes, Reals);

TYPED_TEST(Vertex_lanes, are_loaded_from_any_place_and_stored_there)
{
  TypeParam from[5] = {0, 1, 2, 3, 4}, to[5] = {};
  typename TestFixture::Register v;
  TestFixture::Lanes::load(from + 1, v);
  TestFixture::Lanes::store(to, v);
  for (int q = 0; q < 4; ++q) EXPECT_EQ(to[q], from[q + 1]);
  EXPECT_EQ(to[4], 0);
}

TYPED_TEST(Vertex_lanes, are_multiplied_by_the_imaginary_units_from_the_left)
{
  using Q = typename TestFixture::Quaternionic;
  const Q q = this->random_quaternion();
  typename TestFixture::Register i, j, k;
  this->load(q, i), this->load(q, j), this->load(q, k);
  TestFixture::Lanes::multiply_by_i(i);
  TestFixture::Lanes::multiply_by_j(j);
  TestFixture::Lanes::multiply_by_k(k);
  this->expect_equal(i, Q{0, 1, 0, 0} * q);
  this->expect_equal(j, Q{0, 0, 1, 0} * q);
  this->expect_equal(k, Q{0, 0, 0, 1} * q);
}

TYPED_TEST(Vertex_lanes, of_quaternions_sum_products_with_conjugates)
{
  using Q = typename TestFixture::Quaternionic;
  const Q a = this->random_quaternion(), b = this->random_quaternion();
  const Q p = this->random_quaternion(), q = this->random_quaternion();
  const Q y = this->random_quaternion();
  typename TestFixture::Register lanes_p, lanes_q, lanes_y;
  this->load(p, lanes_p), this->load(q, lanes_q), this->load(y, lanes_y);
  CGP::internal::Conjugate_sum<Q> sum;
  sum.add(a, lanes_p);
  sum.add(b, lanes_q);
  sum.subtract_from(lanes_y);
  this->expect_equal(lanes_y, y - conjugate(a) * p - conjugate(b) * q);
}

TYPED_TEST(Vertex_lanes, of_quaternions_scatter_products)
{
  using Q = typename TestFixture::Quaternionic;
  const Q a = this->random_quaternion(), x = this->random_quaternion();
  const Q y = this->random_quaternion();
  typename TestFixture::Register lanes_x, lanes_y;
  this->load(x, lanes_x), this->load(y, lanes_y);
  CGP::internal::Scattered_product<Q>(lanes_x).subtract(a, lanes_y);
  this->expect_equal(lanes_y, y - a * x);
}

TYPED_TEST(Vertex_lanes, of_numbers_are_four_right_hand_sides)
{
  using Q = typename TestFixture::Quaternionic;
  const Q x = this->random_quaternion(), y = this->random_quaternion();
  typename TestFixture::Register lanes_x, gathered, scattered;
  this->load(x, lanes_x), this->load(y, gathered), this->load(y, scattered);
  CGP::internal::Conjugate_sum<TypeParam> sum;
  sum.add(2, lanes_x);
  sum.add(TypeParam(0.5), lanes_x);
  sum.subtract_from(gathered);
  this->expect_equal(gathered, y - TypeParam(2.5) * x);
  CGP::internal::Scattered_product<TypeParam>(lanes_x).subtract(3, scattered);
  this->expect_equal(scattered, y - TypeParam(3) * x);
}

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
