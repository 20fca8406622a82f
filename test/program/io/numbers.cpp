// Tests examples/conformal/io/file/numbers.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/file/numbers.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

namespace cgp_test::numbers_tests {

using namespace conformal;

TEST(Numbers, are_read_from_their_first_to_their_last_character)
{
  EXPECT_EQ(parse_double("-1.5e2"), -150.0);
  EXPECT_EQ(parse_double("+.5"), 0.5);
  EXPECT_EQ(parse_float("0.1"), 0.1f);
  EXPECT_EQ(parse_integer("+12"), 12);
  for (const char* word : {"", "+", "+-1", "++1", "1,5", "0x10", "1.0D+00", "1e", "--1", "one"})
    EXPECT_FALSE(parse_double(word)) << word;
  for (const char* word : {"", "1.0", "1e3", "+-1", "9223372036854775808"})
    EXPECT_FALSE(parse_integer(word)) << word;
}

TEST(Numbers, too_large_are_infinite_and_too_small_are_zero)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parse_double("1e400"), infinity);
  EXPECT_EQ(parse_double("-1e400"), -infinity);
  EXPECT_EQ(parse_double("1e-400"), 0.0);
  EXPECT_TRUE(std::signbit(*parse_double("-1e-400")));
  EXPECT_EQ(parse_double(std::string(400, '9')), infinity);
  EXPECT_EQ(parse_double("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(parse_double("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_float("1e39"), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(*parse_double("nan")));
}

TEST(Numbers, are_written_as_short_as_they_read_back_the_same)
{
  for (const double value : {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -0.0, 123456789.0}) {
    std::string text;
    append_number(text, value);
    EXPECT_EQ(parse_double(text), value) << text;
    EXPECT_EQ(std::signbit(*parse_double(text)), std::signbit(value));
  }
  std::string text;
  append_number(text, 0.1);
  append_number(text += ' ', 0.1f);
  append_number(text += ' ', std::int64_t{-7});
  EXPECT_EQ(text, "0.1 0.1 -7");
}

TEST(Numbers, do_not_depend_on_the_locale)
{
  // Where no locale with a decimal comma is installed, this is the test above once more.
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  std::string text;
  append_number(text, 1.5);
  EXPECT_EQ(text, "1.5");
  EXPECT_EQ(parse_double("2.25"), 2.25);
  std::setlocale(LC_ALL, "C");
}

TEST(Numbers, words_in_quotes_are_short_and_printable)
{
  EXPECT_EQ(in_quotes("abc"), "'abc'");
  EXPECT_EQ(in_quotes(std::string("a\0\x1b", 3)),
            "'a?"
            "?'");
  EXPECT_EQ(in_quotes(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace cgp_test::numbers_tests
