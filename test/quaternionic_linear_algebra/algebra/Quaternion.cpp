// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <complex>
#include <limits>
#include <random>

namespace cgp_test::quaternion_tests {

namespace CGP = Conformal_geometry_processing;

template <class FT>
class Quaternion : public testing::Test {
 protected:
  using Value = CGP::Quaternion<FT>;
  using Vector3 = Eigen::Matrix<FT, 3, 1>;

  Value random_quaternion() { return {number(), number(), number(), number()}; }
  Vector3 random_vector() { return {number(), number(), number()}; }

  void expect_near(const Value& p, const Value& q)
  {
    EXPECT_LE(CGP::norm(p - q), 100 * std::numeric_limits<FT>::epsilon());
  }
  void expect_near(const Vector3& p, const Vector3& q)
  {
    EXPECT_LE((p - q).norm(), 100 * std::numeric_limits<FT>::epsilon());
  }

 private:
  FT number() { return static_cast<FT>(m_number(m_generator)); }

  std::mt19937 m_generator{7};
  std::uniform_real_distribution<double> m_number{-1, 1};
};

using Fields = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(Quaternion, Fields);

TYPED_TEST(Quaternion, multiplies_the_units_as_Hamilton_did)
{
  using Q = CGP::Quaternion<TypeParam>;
  constexpr Q one{1, 0, 0, 0}, i{0, 1, 0, 0}, j{0, 0, 1, 0}, k{0, 0, 0, 1};
  static_assert(i * j == k && j * k == i && k * i == j);
  static_assert(j * i == -k && k * j == -i && i * k == -j);
  static_assert(i * i == -one && j * j == -one && k * k == -one && i * j * k == -one);
  static_assert(one * k == k && k * one == k && i != j);
}

TYPED_TEST(Quaternion, starts_at_zero)
{
  static_assert(CGP::Quaternion<TypeParam>{} == CGP::Quaternion<TypeParam>{0, 0, 0, 0});
}

TYPED_TEST(Quaternion, is_an_associative_algebra)
{
  for (int n = 0; n < 20; ++n) {
    const auto p = this->random_quaternion(), q = this->random_quaternion(),
               r = this->random_quaternion();
    this->expect_near((p * q) * r, p * (q * r));
    this->expect_near(p * (q + r), p * q + p * r);
    this->expect_near((p - q) * r, p * r - q * r);
    this->expect_near(TypeParam(2) * p * q, p * (q * TypeParam(2)));
    this->expect_near((p / TypeParam(4)) * TypeParam(4), p);
  }
}

TYPED_TEST(Quaternion, conjugates_products_in_reverse)
{
  for (int n = 0; n < 20; ++n) {
    const auto p = this->random_quaternion(), q = this->random_quaternion();
    this->expect_near(CGP::conjugate(p * q), CGP::conjugate(q) * CGP::conjugate(p));
  }
}

TYPED_TEST(Quaternion, has_a_multiplicative_norm)
{
  using Q = CGP::Quaternion<TypeParam>;
  EXPECT_EQ(CGP::norm(Q{1, -2, 4, 10}), TypeParam(11));
  EXPECT_EQ(CGP::squared_norm(Q{1, -2, 4, 10}), TypeParam(121));
  for (int n = 0; n < 20; ++n) {
    const auto p = this->random_quaternion(), q = this->random_quaternion();
    EXPECT_NEAR(static_cast<double>(CGP::norm(p * q)),
                static_cast<double>(CGP::norm(p) * CGP::norm(q)), 1e-5);
    EXPECT_NEAR(static_cast<double>(CGP::dot(p, q)), static_cast<double>((CGP::conjugate(p) * q).w),
                1e-6);
    this->expect_near(CGP::conjugate(q) * q, Q{CGP::squared_norm(q), 0, 0, 0});
  }
}

TYPED_TEST(Quaternion, has_inverses_on_both_sides)
{
  using Q = CGP::Quaternion<TypeParam>;
  for (int n = 0; n < 20; ++n) {
    const auto q = this->random_quaternion();
    this->expect_near(q * CGP::inverse(q), Q{1, 0, 0, 0});
    this->expect_near(CGP::inverse(q) * q, Q{1, 0, 0, 0});
  }
}

TYPED_TEST(Quaternion, multiplies_vectors_by_cross_and_scalar_product)
{
  for (int n = 0; n < 20; ++n) {
    const auto u = this->random_vector(), v = this->random_vector();
    const auto product = CGP::imaginary(u) * CGP::imaginary(v);
    EXPECT_NEAR(static_cast<double>(product.w), static_cast<double>(-u.dot(v)), 1e-6);
    this->expect_near(CGP::imaginary_part(product), u.cross(v).eval());
  }
}

TYPED_TEST(Quaternion, spins_by_plus_theta_by_the_right_hand_rule)
{
  using Q = CGP::Quaternion<TypeParam>;
  const TypeParam theta = TypeParam(0.7), r = 3;
  const TypeParam c = std::cos(theta / 2), s = std::sin(theta / 2);
  // About z: the x axis turns towards y.
  const Eigen::Matrix<TypeParam, 3, 1> x(1, 0, 0),
      turned(r * r * std::cos(theta), r * r * std::sin(theta), 0);
  this->expect_near(CGP::spin(Q{r * c, 0, 0, -r * s}, x), turned);
}

TYPED_TEST(Quaternion, spins_as_a_rotation_matrix_does)
{
  using Q = CGP::Quaternion<TypeParam>;
  const TypeParam theta = TypeParam(1.3);
  const Eigen::Matrix<TypeParam, 3, 1> u = this->random_vector().normalized();
  const Eigen::Matrix<TypeParam, 3, 1> v = this->random_vector();
  const Eigen::Matrix<TypeParam, 3, 1> t = -std::sin(theta / 2) * u;
  const Eigen::Matrix<TypeParam, 3, 1> expected = Eigen::AngleAxis<TypeParam>(theta, u) * v;
  this->expect_near(CGP::spin(Q{std::cos(theta / 2), t[0], t[1], t[2]}, v), expected);
}

TEST(Scalar_traits, turn_numbers_into_scalars_and_back)
{
  using Q = CGP::Quaternion<double>;
  EXPECT_EQ(CGP::internal::Scalar_traits<double>::real(3.), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<std::complex<double>>::real({3., 4.}), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<Q>::real({3, 4, 5, 6}), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<double>::from_real(3.), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<std::complex<double>>::from_real(3.), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<Q>::from_real(3.), (Q{3, 0, 0, 0}));
  EXPECT_EQ(CGP::conjugate(2.), 2.);
  EXPECT_EQ(CGP::conjugate(std::complex<double>(1, 2)), std::complex<double>(1, -2));
}

}  // namespace cgp_test::quaternion_tests
