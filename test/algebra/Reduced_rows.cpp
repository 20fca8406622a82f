// Tests include/Conformal_geometry_processing/algebra/Reduced_rows.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/algebra/Reduced_rows.h>
#include <Conformal_geometry_processing/exceptions.h>

#include <gtest/gtest.h>

namespace cgp_test::reduced_rows_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Reduced_rows;

TEST(Reduced_rows, number_their_coordinates_row_by_row)
{
  const Reduced_rows rows(5, {3, 0});
  EXPECT_EQ(rows.size(), 5);
  EXPECT_EQ(rows.size_of_reduced(), 2);
  EXPECT_EQ(rows.dimension(), 16);
  const int first[] = {0, 2, 6, 10, 12}, dimension[] = {2, 4, 4, 2, 4};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(rows.first(i), first[i]);
    EXPECT_EQ(rows.dimension(i), dimension[i]);
    EXPECT_EQ(rows.is_reduced(i), i == 0 || i == 3);
  }
}

TEST(Reduced_rows, are_equal_whatever_their_order)
{
  EXPECT_EQ(Reduced_rows(5, {3, 0}), Reduced_rows(5, {0, 3}));
  EXPECT_NE(Reduced_rows(5, {3, 0}), Reduced_rows(5, {3}));
  EXPECT_NE(Reduced_rows(5, {3, 0}), Reduced_rows(6, {3, 0}));
  EXPECT_EQ(Reduced_rows(), Reduced_rows(0, {}));
}

TEST(Reduced_rows, refuse_rows_that_do_not_exist)
{
  EXPECT_THROW(Reduced_rows(5, {5}), CGP::Precondition_error);
  EXPECT_THROW(Reduced_rows(5, {0, -1}), CGP::Precondition_error);
}

TEST(Reduced_rows, refuse_a_row_that_comes_twice)
{
  EXPECT_THROW(Reduced_rows(5, {1, 2, 1}), CGP::Precondition_error);
}

}  // namespace cgp_test::reduced_rows_tests
