// Tests vector_units/Panel_kernels.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Aligned_array.h>
#include <Quaternionic_linear_algebra/vector_units/Front_kernels.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/dense_fronts.h"
#include "support/decompositions.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace cgp_test::front_kernels_tests {

template <class Kind>
class Panel_layout : public testing::Test {};
TYPED_TEST_SUITE(Panel_layout, Kinds);

TYPED_TEST(Panel_layout, tells_where_an_entry_of_the_panel_is)
{
  on_every_unit([] {
    const CGP::internal::Panel_layout layout = TypeParam::layout();
    for (int j = 0; j < 11; ++j)
      for (int i = j; i < 34; ++i)
        EXPECT_EQ(at(static_cast<int>(layout.in_panel(11, i, j))), in_panel<TypeParam>(11, i, j));
  });
}

TYPED_TEST(Panel_layout, tells_where_an_entry_of_the_update_is)
{
  on_every_unit([] {
    const CGP::internal::Panel_layout layout = TypeParam::layout();
    for (int j = 0; j < 23; ++j)
      for (int i = j; i < 23; ++i)
        EXPECT_EQ(at(static_cast<int>(layout.in_update(layout.blocks(23), i, j))),
                  in_update<TypeParam>(23, i, j));
  });
}

TEST(Panel_layout_of_two_planes, has_room_for_whole_row_blocks)
{
  constexpr CGP::internal::Panel_layout layout = {2, 3};
  static_assert(layout.lanes() == 8 && layout.cell() == 16 && layout.tile_size() == 128);
  EXPECT_EQ(layout.blocks(0), 0);
  EXPECT_EQ(layout.blocks(9), 2);
  EXPECT_EQ(layout.panel_size(3, 9), 3 * 3 * 16);
  EXPECT_EQ(layout.update_size(9), 3 * 128);
}

template <class Kind>
class Front_kernels : public testing::Test {
 protected:
  using Scalar = typename Kind::Scalar;
  using Real = typename Kind::Real;

  void set_panel(const CGP::Block<Scalar>& A, int width)
  {
    columns = width, below = static_cast<int>(A.rows()) - width;
    panel.resize(Kind::layout().panel_size(columns, below));
    std::fill_n(panel.data(), panel.size(), Real(0));
    for (int j = 0; j < columns; ++j)
      for (int i = j; i < columns + below; ++i)
        put<Kind>(A(i, j), panel.data() + in_panel<Kind>(columns, i, j));
  }

  int factor_panel()
  {
    const CGP::internal::Panel_layout layout = Kind::layout();
    return Kind::kernels().factor_panel(panel.data(), columns,
                                        layout.blocks(columns) + layout.blocks(below));
  }

  CGP::Block<Scalar> factor() const
  {
    CGP::Block<Scalar> L = CGP::Block<Scalar>::Constant(columns + below, columns, Scalar{});
    for (int j = 0; j < columns; ++j)
      for (int i = j; i < columns + below; ++i)
        L(i, j) = get<Kind>(panel.data() + in_panel<Kind>(columns, i, j));
    return L;
  }

  int columns = 0, below = 0;
  CGP::internal::Aligned_array<Real> panel;
};
TYPED_TEST_SUITE(Front_kernels, Kinds);

constexpr int sizes[][2] = {{1, 0}, {1, 1}, {2, 9}, {3, 5}, {8, 8}, {13, 20}, {17, 0}, {64, 33}};

TYPED_TEST(Front_kernels, factor_a_panel_as_a_dense_cholesky_factorization_does)
{
  on_every_unit([&] {
    for (const auto& [k, u] : sizes) {
      SCOPED_TRACE(testing::Message() << k << " columns and " << u << " rows below");
      const auto A = random_definite_block<TypeParam>(k + u, 3);
      this->set_panel(A, k);
      ASSERT_EQ(this->factor_panel(), -1);
      const Eigen::MatrixXd expected = cholesky_factor(real_form(A));
      const Eigen::MatrixXd found = real_form(this->factor());
      EXPECT_LE((found - expected.leftCols(found.cols())).norm(),
                TypeParam::precision * expected.norm());
    }
  });
}

TYPED_TEST(Front_kernels, do_the_rows_below_in_parts_as_well)
{
  on_every_unit([&] {
    const auto front = TypeParam::kernels();
    const CGP::internal::Panel_layout layout = TypeParam::layout();
    for (const auto& [k, u] : sizes) {
      SCOPED_TRACE(testing::Message() << k << " columns and " << u << " rows below");
      const auto A = random_definite_block<TypeParam>(k + u, 6);
      this->set_panel(A, k);
      ASSERT_EQ(this->factor_panel(), -1);
      const Eigen::MatrixXd expected = real_form(this->factor());
      this->set_panel(A, k);
      const int triangle = layout.blocks(k), all = triangle + layout.blocks(u);
      ASSERT_EQ(front.factor_panel(this->panel.data(), k, triangle), -1);
      for (int b = all; b > triangle; b -= 3)
        front.solve_below(this->panel.data(), k, std::max(triangle, b - 3), b);
      EXPECT_LE((real_form(this->factor()) - expected).norm(),
                TypeParam::precision * expected.norm());

      CGP::internal::Aligned_array<typename TypeParam::Real> whole, parts;
      whole.resize(layout.update_size(u));
      parts.resize(layout.update_size(u));
      const auto* const under = this->panel.data() + layout.panel_size(k, 0);
      front.set_outer_product(whole.data(), under, k, u, 0, layout.blocks(u));
      for (int b = layout.blocks(u); b > 0; b -= 2)
        front.set_outer_product(parts.data(), under, k, u, std::max(0, b - 2), b);
      for (int j = 0; j < u; ++j)
        for (int i = j; i < u; ++i)
          EXPECT_EQ(get<TypeParam>(whole.data() + in_update<TypeParam>(u, i, j)),
                    get<TypeParam>(parts.data() + in_update<TypeParam>(u, i, j)));
    }
  });
}

TYPED_TEST(Front_kernels, leave_zeros_above_the_diagonal_and_in_rows_that_do_not_exist)
{
  on_every_unit([&] {
    const int lanes = TypeParam::layout().lanes();
    const int k = lanes + 3, u = lanes + 1;
    this->set_panel(random_definite_block<TypeParam>(k + u, 5), k);
    ASSERT_EQ(this->factor_panel(), -1);
    double sum = 0;
    for (std::int64_t i = 0; i < this->panel.size(); ++i) sum += std::abs(this->panel.data()[i]);
    double entries = 0;
    const auto L = this->factor();
    for (const auto& value : L.reshaped()) {
      double parts[TypeParam::planes];
      CGP::internal::Scalar_planes<typename TypeParam::Scalar>::get(value, parts);
      for (double part : parts) entries += std::abs(part);
    }
    EXPECT_NEAR(sum, entries, 1e-12 * entries);
  });
}

TYPED_TEST(Front_kernels, round_each_column_to_multiples_of_a_unit)
{
  using Stored = typename TypeParam::Real;
  on_every_unit([&] {
    const auto kernels = TypeParam::kernels();
    const auto& layout = kernels.layout;
    const int width = 5, blocks = layout.blocks(width) + 2, cell = layout.cell();
    CGP::internal::Aligned_array<Stored> numbers;
    CGP::internal::Aligned_array<std::int16_t> rounded;
    numbers.resize(blocks * width * cell);
    rounded.resize(numbers.size());
    Stored units[width], inverses[width];
    for (int i = 0; i < numbers.size(); ++i)  // column 2 is too small, column 3 zero
      numbers.data()[i] = static_cast<Stored>(std::sin(i + 1) * (i / cell % width != 3) *
                                              std::pow(10., i / cell % width * -20));
    const std::vector<Stored> before(numbers.data(), numbers.data() + numbers.size());
    kernels.round_panel(numbers.data(), width, blocks, rounded.data(), units, inverses);
    for (int j = 0; j < width; ++j) {
      const int diagonal = static_cast<int>(layout.in_panel(width, j, j));
      const Stored unit = units[j], number = before[static_cast<std::size_t>(diagonal)];
      EXPECT_LE(unit, Stored(1.0001) / 32000);
      int far = 0;
      std::vector<double> sums(static_cast<std::size_t>(TypeParam::planes), 0.);
      for (int i = layout.block(j) * width * cell; i < numbers.size(); ++i) {
        if (i / cell % width != j) continue;
        const bool is_above =
            i / cell / width == layout.block(j) && i % layout.lanes() <= layout.lane(j);
        const double exact = is_above ? 0 : before[static_cast<std::size_t>(i)];
        const double error = double(unit) * rounded.data()[i] - exact;
        EXPECT_LE(std::abs(error), j < 2 ? 100. * unit : 1e-30);
        far += std::abs(error) > 0.51 * unit;
        sums[static_cast<std::size_t>(i % cell / layout.lanes())] += error;
      }
      if (j >= 2) continue;
      EXPECT_NEAR(inverses[j] * number, 1, 1e-6);
      EXPECT_LE(far, TypeParam::planes) << "one row makes up for the others";
      for (const double sum : sums) EXPECT_LE(std::abs(sum), 0.6 * unit);
    }
    EXPECT_GT(units[1], Stored(0.9e-20) / 32000);
  });
}

TYPED_TEST(Front_kernels, hand_minus_the_outer_product_to_the_parent)
{
  on_every_unit([&] {
    const auto front = TypeParam::kernels();
    const CGP::internal::Panel_layout layout = TypeParam::layout();
    for (const auto& [k, u] : sizes) {
      SCOPED_TRACE(testing::Message() << k << " columns and " << u << " rows below");
      const auto A = random_block<typename TypeParam::Scalar>(k + u, k, 7);
      this->set_panel(A, k);
      CGP::internal::Aligned_array<typename TypeParam::Real> update;
      update.resize(layout.update_size(u));
      std::fill_n(update.data(), update.size(), typename TypeParam::Real(77));
      front.set_outer_product(update.data(), this->panel.data() + layout.panel_size(k, 0), k, u, 0,
                              layout.blocks(u));
      const Eigen::MatrixXd L = real_form(A).bottomRows(TypeParam::planes * u);
      const Eigen::MatrixXd expected = -L * L.transpose();
      CGP::Block<typename TypeParam::Scalar> found(u, u);
      for (int j = 0; j < u; ++j)
        for (int i = 0; i < u; ++i) {
          const auto* const lower =
              update.data() + in_update<TypeParam>(u, std::max(i, j), std::min(i, j));
          found(i, j) = i >= j ? get<TypeParam>(lower) : CGP::conjugate(get<TypeParam>(lower));
        }
      EXPECT_LE((real_form(found) - expected).norm(), TypeParam::precision * expected.norm());
    }
  });
}

TYPED_TEST(Front_kernels, name_the_column_whose_pivot_is_not_positive)
{
  on_every_unit([&] {
    using Traits = CGP::internal::Scalar_traits<typename TypeParam::Scalar>;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const int k = 20;
    for (const int column : {0, 1, 7, 8, 19})
      for (const double value : {-1.0, 0.0, nan}) {
        auto A = random_definite_block<TypeParam>(k + 4, 9);
        A(column, column) = Traits::from_real(value);
        this->set_panel(A, k);
        EXPECT_EQ(this->factor_panel(), column);
      }
  });
}

}  // namespace cgp_test::front_kernels_tests
