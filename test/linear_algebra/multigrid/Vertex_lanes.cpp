// Tests include/Conformal_geometry_processing/linear_algebra/multigrid/Vertex_lanes.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/multigrid/Vertex_lanes.h>

#include <gtest/gtest.h>

#include "support/random.h"

namespace cgp_test::vertex_lanes_tests {

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

}  // namespace cgp_test::vertex_lanes_tests
