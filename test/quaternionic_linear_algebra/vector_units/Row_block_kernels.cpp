// Tests include/Quaternionic_linear_algebra/vector_units/Substitution_kernels.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/vector_units/Substitution_kernels.h>

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test::row_block_kernels_tests {

// Small whole numbers: every sum is exact.
template <class Kind>
class Row_block_kernels : public testing::Test {
 protected:
  using Scalar = typename Kind::Scalar;
  using Planes = CGP::internal::Scalar_planes<Scalar>;
  using Kernels = CGP::internal::Row_block_kernels<CGP::internal::Target_unit, double, Planes::size,
                                                   Kind::numbers>;
  static constexpr int lanes = Kernels::lanes, numbers = Kind::numbers, planes = Planes::size;

  static void fill(double* p, int count, int seed)
  {
    for (int i = 0; i < count; ++i) p[i] = (seed + i * i) % 11 - 5;
  }
  // Of a cell or a row block, the scalar of right-hand side c in a lane.
  static Scalar scalar(const double* block, int c, int lane)
  {
    double parts[planes];
    for (int q = 0; q < planes; ++q) parts[q] = block[(c * planes + q) * lanes + lane];
    return Planes::put(parts);
  }
  static Scalar in_row(const double* row, int c) { return Planes::put(row + c * planes); }

  static void expect_equal(const Scalar& a, const Scalar& b)
  {
    double x[planes], y[planes];
    Planes::get(a, x), Planes::get(b, y);
    for (int q = 0; q < planes; ++q) EXPECT_EQ(x[q], y[q]);
  }

  void SetUp() override
  {
    fill(L, Kernels::cell, 1);
    fill(row, numbers, 2);
    fill(block, Kernels::wide, 3);
    fill(other, Kernels::wide, 5);
    std::copy(block, block + Kernels::wide, before);
    Kernels::load(block, acc);
  }

  alignas(64) double L[Kernels::cell], block[Kernels::wide], other[Kernels::wide];
  double before[Kernels::wide], row[numbers];
  typename Kernels::Accumulators acc;
};

template <class Scalar_, int numbers_>
struct Kind_of_row {
  using Scalar = Scalar_;
  static constexpr int numbers = numbers_;
};
using Kinds_of_rows =
    testing::Types<Kind_of_row<double, 4>, Kind_of_row<std::complex<double>, 8>,
                   Kind_of_row<Quaternion<double>, 4>, Kind_of_row<Quaternion<double>, 8>>;
TYPED_TEST_SUITE(Row_block_kernels, Kinds_of_rows);

TYPED_TEST(Row_block_kernels, subtract_a_column_of_the_factor_times_a_row)
{
  TestFixture::Kernels::subtract(this->acc, this->L, this->row);
  TestFixture::Kernels::store(this->block, this->acc);
  for (int c = 0; c < TestFixture::Kernels::columns; ++c)
    for (int l = 0; l < this->lanes; ++l)
      this->expect_equal(this->scalar(this->block, c, l),
                         this->scalar(this->before, c, l) -
                             this->scalar(this->L, 0, l) * this->in_row(this->row, c));
}

TYPED_TEST(Row_block_kernels, add_the_conjugate_of_a_column_of_the_factor_times_a_row_block)
{
  typename TestFixture::Kernels::Accumulators y;
  TestFixture::Kernels::load(this->other, y);
  TestFixture::Kernels::add_conjugate(this->acc, this->L, y);
  TestFixture::Kernels::store(this->block, this->acc);
  for (int c = 0; c < TestFixture::Kernels::columns; ++c)
    for (int l = 0; l < this->lanes; ++l)
      this->expect_equal(
          this->scalar(this->block, c, l),
          this->scalar(this->before, c, l) +
              CGP::conjugate(this->scalar(this->L, 0, l)) * this->scalar(this->other, c, l));
}

TYPED_TEST(Row_block_kernels, solve_a_row_for_the_sums_of_the_lanes)
{
  double y[TestFixture::numbers];
  std::copy(this->row, this->row + this->numbers, y);
  TestFixture::Kernels::solve_row(this->acc, 4, 0.5, y);
  for (int i = 0; i < this->numbers; ++i) {
    double sum = 0;
    for (int l = 0; l < this->lanes; ++l) sum += this->before[i * this->lanes + l];
    EXPECT_EQ(y[i], (this->row[i] - 4 * sum) / 2);
  }
}

TYPED_TEST(Row_block_kernels, put_a_row_into_its_lane_and_leave_the_others)
{
  const int lane = this->lanes - 1;
  TestFixture::Kernels::set_lane(this->acc, lane, this->row);
  TestFixture::Kernels::store(this->block, this->acc);
  for (int i = 0; i < this->numbers; ++i)
    for (int l = 0; l < this->lanes; ++l)
      EXPECT_EQ(this->block[i * this->lanes + l],
                l == lane ? this->row[i] : this->before[i * this->lanes + l]);
}

}  // namespace cgp_test::row_block_kernels_tests
