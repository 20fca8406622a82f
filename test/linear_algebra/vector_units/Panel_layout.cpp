// Tests include/Conformal_geometry_processing/linear_algebra/vector_units/Panel_layout.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/vector_units/Panel_layout.h>

#include <gtest/gtest.h>

#include "linear_algebra/dense_fronts.h"

namespace cgp_test::panel_layout_tests {

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

}  // namespace cgp_test::panel_layout_tests
