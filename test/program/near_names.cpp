// Tests examples/conformal/process/near_names.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/process/near_names.h"

#include <gtest/gtest.h>

namespace cgp_test::near_names_tests {

using conformal::near_names;
using Names = std::vector<std::string>;

const Names names = {"output", "rho-expression", "rho-file", "seed", "json", "strict"};

TEST(Near_names, begin_with_the_wrong_one_or_have_it_as_a_word)
{
  EXPECT_EQ(near_names("rho", names), Names({"rho-expression", "rho-file"}));
  EXPECT_EQ(near_names("file", names), Names({"rho-file"}));
  EXPECT_EQ(near_names("Expression", names), Names({"rho-expression"}));
}

TEST(Near_names, are_an_edit_of_each_three_letters_away)
{
  EXPECT_EQ(near_names("ouptut", names), Names({"output"}));
  EXPECT_EQ(near_names("rho-expresion", names), Names({"rho-expression"}));
  EXPECT_EQ(near_names("jsn", names), Names({"json"}));
  EXPECT_EQ(near_names("josn", names), Names({"json"}));
  EXPECT_EQ(near_names("feed", names), Names({"seed"}));
  EXPECT_EQ(near_names("fled", names), Names());
}

TEST(Near_names, are_at_most_five_and_none_of_a_letter)
{
  EXPECT_EQ(near_names("ab", {"ab1", "ab2", "ab3", "ab4", "ab5", "ab6"}).size(), 5u);
  EXPECT_EQ(near_names("x", {"y", "xy"}), Names());
  EXPECT_EQ(near_names("", names), Names());
}

TEST(Near_names, are_listed)
{
  EXPECT_EQ(conformal::listed({}), "");
  EXPECT_EQ(conformal::listed({"a", "b"}), "a, b");
}

}  // namespace cgp_test::near_names_tests
