// Tests linear_algebra/Solver_embedding.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/Solver_embedding.h>

#include <gtest/gtest.h>

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

TEST(Solver_embedding, lets_numbers_stand_for_themselves)
{
  using Embedding = CGP::Solver_embedding<double>;
  static_assert(Embedding::width == 1);
  double entry = 0;
  Embedding::to_entries(3, &entry);
  EXPECT_EQ(entry, 3);
  EXPECT_EQ(Embedding::from_entries(&entry), 3);
  EXPECT_EQ(Embedding::block(-2)(0, 0), -2);
}

TEST(Solver_embedding, lets_quaternions_act_on_pairs_of_complex_numbers)
{
  using Embedding = CGP::Solver_embedding<Q>;
  static_assert(Embedding::width == 2);
  const Q p{1, 2, 3, 4}, q{-1, 0.5, 2, 1};
  Eigen::Vector2cd entries;
  Embedding::to_entries(q, entries.data());
  EXPECT_EQ(Embedding::from_entries(entries.data()), q);
  const Eigen::Vector2cd product = Embedding::block(p) * entries;
  EXPECT_EQ(Embedding::from_entries(product.data()), p * q);
}
