// Tests examples/conformal/io/data/Property.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/data/Property.h"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

namespace cgp_test::property_tests {

using namespace conformal;

TEST(Property, keeps_every_type_exactly)
{
  const std::vector<std::pair<Value_type, double>> extremes = {
      {Value_type::int8, -128},           {Value_type::uint8, 255},
      {Value_type::int16, -32768},        {Value_type::uint16, 65535},
      {Value_type::int32, -2147483648.0}, {Value_type::uint32, 4294967295.0},
      {Value_type::float32, 0.5},         {Value_type::float64, 1e300}};
  for (const auto& [type, value] : extremes) {
    Property property("p", type);
    property.append(value);
    EXPECT_EQ(property.value(0), value) << name_of(type);
    EXPECT_EQ(value_type(name_of(type)), type);
  }
  EXPECT_EQ(value_type("float64"), Value_type::float64);
  EXPECT_FALSE(value_type("quaternion"));
}

TEST(Property, keeps_the_bits_of_a_nan)
{
  const std::uint32_t payload = 0xffc12345u;
  unsigned char bytes[4];
  std::memcpy(bytes, &payload, 4);
  Property property("p", Value_type::float32);
  property.append_bytes(bytes, false);
  EXPECT_EQ(std::memcmp(property.bytes(0), bytes, 4), 0);
}

TEST(Property, of_lists_has_rows_of_any_length)
{
  Property property("p", Value_type::uint8, Value_type::int32);
  property.append(4);
  property.append(5);
  property.end_list();
  property.end_list();
  EXPECT_EQ(property.rows(), 2u);
  EXPECT_EQ(property.count(0), 2u);
  EXPECT_EQ(property.count(1), 0u);
  EXPECT_EQ(property.integer(property.first(0) + 1), 5);
}

TEST(Property, fits_the_range_of_an_integer_type)
{
  EXPECT_TRUE(fits(Value_type::int8, -128));
  EXPECT_FALSE(fits(Value_type::int8, 128));
  EXPECT_TRUE(fits(Value_type::uint32, 4294967295));
  EXPECT_FALSE(fits(Value_type::uint32, -1));
}

TEST(Property, is_replaced_where_it_stands)
{
  Element element{"vertex", 2, {}};
  set_property(element, "quality", std::vector<float>{1.0f, 2.0f});
  set_property(element, "label", std::vector<double>{3.0, 4.0});
  set_property(element, "quality", std::vector<float>{5.0f, 6.0f});
  ASSERT_EQ(element.properties.size(), 2u);
  EXPECT_EQ(element.properties[0].name(), "quality");
  EXPECT_EQ(element.properties[0].value(1), 6.0);
  EXPECT_EQ(element.properties[1].type(), Value_type::float64);
  remove_property(element, "quality");
  EXPECT_EQ(find_property(element, "quality"), nullptr);
}

TEST(Property, is_found_by_what_it_holds)
{
  Element element{"vertex", 1, {}};
  element.properties.emplace_back("list", Value_type::uint8, Value_type::float32);
  element.properties.back().end_list();
  set_property(element, "number", std::vector<float>{1.0f});
  EXPECT_EQ(find_numbers(element, "list"), nullptr);
  EXPECT_EQ(find_list(element, "number"), nullptr);
  EXPECT_EQ(find_list(element, "list"), find_property(element, "list"));
  EXPECT_EQ(find_numbers(element, "number"), find_property(element, "number"));
}

TEST(Property, is_not_read_past_its_end)
{
  Property list("list", Value_type::uint8, Value_type::float32);
  list.end_list();  // a row without values
  EXPECT_EQ(list.rows(), 1u);
  EXPECT_THROW(list.value(0), std::out_of_range);
  EXPECT_THROW(list.bytes(0), std::out_of_range);
}

TEST(Property, has_a_name_of_one_word)
{
  using namespace std::string_literals;
  for (const std::string& name : {"a b"s, "a\nproperty float q"s, "a\t"s, "a\0b"s})
    EXPECT_THROW(Property(name, Value_type::float32), std::invalid_argument);
}

TEST(Property, of_another_size_is_refused)
{
  Element element{"vertex", 2, {}};
  EXPECT_THROW(set_property(element, "quality", std::vector<float>{1.0f}), std::invalid_argument);
}

}  // namespace cgp_test::property_tests
