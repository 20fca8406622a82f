// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Property.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace conformal {
namespace {

struct Type_facts {
  std::string_view name, other_name;
  std::size_t size;
  std::int64_t lowest, highest;  // of the integer types
};

template <class Integer>
constexpr Type_facts integer_facts(std::string_view name, std::string_view other_name)
{
  using Limits = std::numeric_limits<Integer>;
  return {name, other_name, sizeof(Integer), Limits::min(), Limits::max()};
}

// in the order of Value_type
constexpr std::array<Type_facts, 8> types = {
    integer_facts<std::int8_t>("char", "int8"),    integer_facts<std::uint8_t>("uchar", "uint8"),
    integer_facts<std::int16_t>("short", "int16"), integer_facts<std::uint16_t>("ushort", "uint16"),
    integer_facts<std::int32_t>("int", "int32"),   integer_facts<std::uint32_t>("uint", "uint32"),
    Type_facts{"float", "float32", 4, 0, 0},       Type_facts{"double", "float64", 8, 0, 0}};

const Type_facts& facts(Value_type type)
{
  return types[static_cast<std::size_t>(type)];
}

// Calls f with a zero of the C++ type that the value type stands for.
template <class Function>
auto with_type(Value_type type, const Function& f)
{
  switch (type) {
    case Value_type::int8:
      return f(std::int8_t());
    case Value_type::uint8:
      return f(std::uint8_t());
    case Value_type::int16:
      return f(std::int16_t());
    case Value_type::uint16:
      return f(std::uint16_t());
    case Value_type::int32:
      return f(std::int32_t());
    case Value_type::uint32:
      return f(std::uint32_t());
    case Value_type::float32:
      return f(float());
    default:
      return f(double());
  }
}

template <class Real>
Property real_property(const std::string& name, Value_type type, const std::vector<Real>& values)
{
  Property property(name, type);
  property.reserve(values.size());
  for (const Real value : values) property.append(static_cast<double>(value));
  return property;
}

}  // namespace

std::size_t size_of(Value_type type)
{
  return facts(type).size;
}

std::string_view name_of(Value_type type)
{
  return facts(type).name;
}

std::optional<Value_type> value_type(std::string_view name)
{
  for (std::size_t i = 0; i < types.size(); ++i)
    if (name == types[i].name || name == types[i].other_name) return static_cast<Value_type>(i);
  return {};
}

bool is_integer(Value_type type)
{
  return type < Value_type::float32;
}

bool fits(Value_type type, std::int64_t value)
{
  return value >= facts(type).lowest && value <= facts(type).highest;
}

bool is_property_name(std::string_view name)
{
  constexpr std::string_view blanks(" \t\v\f\r\n\0", 7);
  return name.find_first_of(blanks) == std::string_view::npos;
}

Property::Property(std::string name, Value_type type) : m_name(std::move(name)), m_type(type)
{
  if (!is_property_name(m_name))
    throw std::invalid_argument("Property: the name '" + m_name + "' has blanks, wanted one word");
}

Property::Property(std::string name, Value_type count_type, Value_type type)
    : Property(std::move(name), type)
{
  m_count_type = count_type;
  m_first.assign(1, 0);
}

const unsigned char* Property::bytes(std::size_t i) const
{
  if (i >= values())
    throw std::out_of_range("Property: value " + std::to_string(i) + " of " + m_name +
                            ", wanted less than " + std::to_string(values()));
  return m_bytes.data() + i * size_of(m_type);
}

double Property::value(std::size_t i) const
{
  return with_type(m_type, [this, i](auto number) {
    std::memcpy(&number, bytes(i), sizeof number);
    return static_cast<double>(number);
  });
}

void Property::append(double value)
{
  with_type(m_type, [this, value](auto number) {
    number = static_cast<decltype(number)>(value);
    std::array<unsigned char, sizeof number> bytes;
    std::memcpy(bytes.data(), &number, sizeof number);
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
  });
}

void Property::append_bytes(const unsigned char* bytes, bool swapped)
{
  m_bytes.insert(m_bytes.end(), bytes, bytes + size_of(m_type));
  if (swapped)
    std::reverse(m_bytes.end() - static_cast<std::ptrdiff_t>(size_of(m_type)), m_bytes.end());
}

const Property* find_property(const Element& element, std::string_view name)
{
  for (const Property& property : element.properties)
    if (property.name() == name) return &property;
  return nullptr;
}

const Property* find_numbers(const Element& element, std::string_view name)
{
  const Property* property = find_property(element, name);
  return property != nullptr && !property->is_list() ? property : nullptr;
}

const Property* find_list(const Element& element, std::string_view name)
{
  const Property* property = find_property(element, name);
  return property != nullptr && property->is_list() ? property : nullptr;
}

void remove_property(Element& element, std::string_view name)
{
  auto& all = element.properties;
  const auto is_named = [name](const Property& property) { return property.name() == name; };
  all.erase(std::remove_if(all.begin(), all.end(), is_named), all.end());
}

void set_property(Element& element, Property property)
{
  if (property.rows() != element.size)
    throw std::invalid_argument("set_property(): " + property.name() + " has " +
                                std::to_string(property.rows()) + " values, wanted one for each " +
                                element.name + ", " + std::to_string(element.size));
  for (Property& present : element.properties)
    if (present.name() == property.name()) {
      present = std::move(property);
      return;
    }
  element.properties.push_back(std::move(property));
}

void set_property(Element& element, const std::string& name, const std::vector<float>& values)
{
  set_property(element, real_property(name, Value_type::float32, values));
}

void set_property(Element& element, const std::string& name, const std::vector<double>& values)
{
  set_property(element, real_property(name, Value_type::float64, values));
}

}  // namespace conformal
