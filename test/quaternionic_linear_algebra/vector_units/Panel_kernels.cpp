// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/vector_units/Panel_kernels.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/dense_fronts.h"

#include <algorithm>
#include <vector>

namespace cgp_test::panel_kernels_tests {

template <class Kind>
class Extend_add : public testing::Test {
 protected:
  using Scalar = typename Kind::Scalar;
  using Real = typename Kind::Real;

  // A child whose row i is row place[i] of the front, on a front of ones.
  void expect_sum(int k, int u, const std::vector<int>& place)
  {
    const CGP::internal::Front_kernels<Real> kernels = Kind::kernels();
    const CGP::internal::Panel_layout& layout = kernels.layout;
    const int n = static_cast<int>(place.size());
    const auto U = random_block<Scalar>(n, n, 11);
    std::vector<Real> child(static_cast<std::size_t>(layout.update_size(n)), Real(99));
    for (int j = 0; j < n; ++j)
      for (int i = j; i < n; ++i) put<Kind>(U(i, j), child.data() + in_update<Kind>(n, i, j));
    std::vector<Real> panel(static_cast<std::size_t>(layout.panel_size(k, u)), Real(1));
    std::vector<Real> update(static_cast<std::size_t>(layout.update_size(u)), Real(1));
    std::vector<Real> expected_panel = panel, expected_update = update;
    for (int j = 0; j < n; ++j)
      for (int i = j; i < n; ++i) {
        const int row = place[at(i)], column = place[at(j)];
        Real* const target = column < k
                                 ? expected_panel.data() + in_panel<Kind>(k, row, column)
                                 : expected_update.data() + in_update<Kind>(u, row - k, column - k);
        double parts[Kind::planes];
        CGP::internal::Scalar_planes<Scalar>::get(U(i, j), parts);
        for (int q = 0; q < Kind::planes; ++q)
          target[q * layout.lanes()] += static_cast<Real>(parts[q]);
      }
    const CGP::internal::Child_update<Real> handed_over = {child.data(), n, place.data()};
    for (int begin = 0; begin < k + u; begin += step)
      kernels.add_to_panel(handed_over, k, panel.data(), begin, std::min(begin + step, k + u));
    for (int begin = 0; begin < u; begin += step)
      kernels.add_to_update(handed_over, k, u, update.data(), begin, std::min(begin + step, u));
    EXPECT_EQ(panel, expected_panel);
    EXPECT_EQ(update, expected_update);
  }

  int step = 1000;  // rows at once
};
TYPED_TEST_SUITE(Extend_add, Kinds);

TYPED_TEST(Extend_add, adds_every_number_where_its_row_and_column_are)
{
  on_every_unit([&] {
    this->expect_sum(3, 4, {0, 2, 3, 6});
    this->expect_sum(1, 0, {0});
    this->expect_sum(20, 0, {0, 5, 18, 19});
    this->expect_sum(2, 5, {2, 3, 4, 6});  // nothing for the panel
  });
}

TYPED_TEST(Extend_add, serves_fronts_of_any_size_one_after_another)
{
  on_every_unit([&] {
    Random random(6);
    for (const int k : {1, 7, 8, 33})
      for (const int u : {0, 5, 16, 70, 400}) {
        std::vector<int> place;
        for (int i = 0; i < k + u; ++i)
          if (random.below(3) > 0) place.push_back(i);
        this->expect_sum(k, u, place);
      }
  });
}

TYPED_TEST(Extend_add, serves_some_rows_after_others)
{
  on_every_unit([&] {
    std::vector<int> place;
    for (int i = 0; i < 60; ++i)
      if (i % 3 > 0) place.push_back(i);
    for (const int rows : {1, 8, 13}) {
      this->step = rows;
      this->expect_sum(20, 40, place);
      this->expect_sum(50, 10, place);
    }
  });
}

}  // namespace cgp_test::panel_kernels_tests
