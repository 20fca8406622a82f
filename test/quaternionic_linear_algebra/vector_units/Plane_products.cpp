// Tests include/Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test::plane_products_tests {

template <class Scalar>
class Plane_products : public testing::Test {
 protected:
  using Components = CGP::internal::Scalar_planes<Scalar>;

  // Starting from c, the product is applied to the components of c, a and b, and compared.
  template <class Product>
  void expect_product(Product product, const Scalar& expected)
  {
    double x[Components::size], y[Components::size], z[Components::size];
    Components::get(m_c, x), Components::get(m_a, y), Components::get(m_b, z);
    product(x, y, z);
    double e[Components::size];
    Components::get(expected, e);
    for (int q = 0; q < Components::size; ++q) EXPECT_NEAR(x[q], e[q], 1e-15);
  }

  Random random{4};
  Scalar m_a = random_scalar<Scalar>(random), m_b = random_scalar<Scalar>(random),
         m_c = random_scalar<Scalar>(random);
};
using Scalars = testing::Types<double, std::complex<double>, Quaternion<double>>;
TYPED_TEST_SUITE(Plane_products, Scalars);

TYPED_TEST(Plane_products, multiply_as_the_scalars_do)
{
  using Planes = CGP::internal::Plane_products<CGP::internal::Scalar_planes<TypeParam>::size>;
  const TypeParam a = this->m_a, b = this->m_b, c = this->m_c;
  this->expect_product([](auto* x, auto* y, auto* z) { Planes::subtract_conjugated(x, y, z); },
                       c - a * CGP::conjugate(b));
  this->expect_product([](auto* x, auto* y, auto* z) { Planes::subtract(x, y, z); }, c - a * b);
  this->expect_product([](auto* x, auto* y, auto* z) { Planes::add_conjugate(x, y, z); },
                       c + CGP::conjugate(a) * b);
}

}  // namespace cgp_test::plane_products_tests
