// Tests linear_algebra/adapters/Solver_embedding.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/adapters/Solver_embedding.h>

#include <gtest/gtest.h>

namespace cgp_test::solver_embedding_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

template <class Embedding>
class Embedding_of_numbers : public testing::Test {};
using Embeddings =
    testing::Types<CGP::internal::Number_embedding<double>,
                   CGP::internal::Complex_embedding<double>, CGP::internal::Real_embedding<double>>;
TYPED_TEST_SUITE(Embedding_of_numbers, Embeddings);

TYPED_TEST(Embedding_of_numbers, lets_them_stand_for_themselves)
{
  static_assert(TypeParam::width == 1);
  double entry = 0;
  TypeParam::to_entries(3, &entry);
  EXPECT_EQ(entry, 3);
  EXPECT_EQ(TypeParam::from_entries(&entry), 3);
  EXPECT_EQ(TypeParam::block(-2)(0, 0), -2);
}

template <class Embedding>
void expect_left_multiplication()
{
  const Q p{1, 2, 3, 4}, q{-1, 0.5, 2, 1};
  Eigen::Matrix<typename Embedding::Entry, Embedding::width, 1> entries;
  Embedding::to_entries(q, entries.data());
  EXPECT_EQ(Embedding::from_entries(entries.data()), q);
  const auto product = (Embedding::block(p) * entries).eval();
  EXPECT_EQ(Embedding::from_entries(product.data()), p * q);
  EXPECT_EQ(Embedding::block(conjugate(p)), Embedding::block(p).adjoint());
}

TEST(Complex_embedding, lets_quaternions_act_on_pairs_of_complex_numbers)
{
  static_assert(CGP::internal::Complex_embedding<Q>::width == 2);
  expect_left_multiplication<CGP::internal::Complex_embedding<Q>>();
}

TEST(Real_embedding, lets_quaternions_act_on_their_four_components)
{
  static_assert(CGP::internal::Real_embedding<Q>::width == 4);
  expect_left_multiplication<CGP::internal::Real_embedding<Q>>();
}

}  // namespace cgp_test::solver_embedding_tests
