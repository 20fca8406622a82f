// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// the eight types of the PLY format
enum class Value_type : unsigned char {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

/// bytes of one value
std::size_t size_of(Value_type type);

/// `char`, `uchar`, ..., `double`: the names that every PLY reader supports
std::string_view name_of(Value_type type);

/// the type of either of its two PLY names (`uchar` or `uint8`), or nothing
std::optional<Value_type> value_type(std::string_view name);

bool is_integer(Value_type type);

/// whether a PLY header can have a property of that name: it separates by blanks and line ends
bool is_property_name(std::string_view name);

/// A column of a file: a name and, per row, one value or a list of values.
///
/// Values are kept in the bytes of their own type, so that they go back to a file bit for bit
/// (NaN payloads included); every value of every type is exact as a double.
class Property {
 public:
  /// \brief one value per row
  /// \throws std::invalid_argument unless `is_property_name(name)`
  Property(std::string name, Value_type type);

  /// a list per row; `count_type` is the type its length has in a PLY file
  Property(std::string name, Value_type count_type, Value_type type);

  const std::string& name() const { return m_name; }
  Value_type type() const { return m_type; }
  bool is_list() const { return !m_first.empty(); }
  Value_type count_type() const { return m_count_type; }

  /// rows, and values in all of them
  std::size_t rows() const { return is_list() ? m_first.size() - 1 : values(); }
  std::size_t values() const { return m_bytes.size() / size_of(m_type); }

  /// the values of a row are [first(row), first(row) + count(row))
  std::size_t first(std::size_t row) const { return is_list() ? m_first[row] : row; }
  std::size_t count(std::size_t row) const
  {
    return is_list() ? m_first[row + 1] - m_first[row] : 1;
  }

  /// value number i of all; the integer one is for integer types only
  double value(std::size_t i) const;
  std::int64_t integer(std::size_t i) const { return static_cast<std::int64_t>(value(i)); }

  /// \brief the bytes of value i in the order of this machine
  /// \throws std::out_of_range unless i < values(): a list may hold fewer values than rows
  const unsigned char* bytes(std::size_t i) const;

  /// appends a value converted to the type; it must be in the type's range
  void append(double value);

  /// appends a value from its bytes in the order of this machine, or in the opposite one
  void append_bytes(const unsigned char* bytes, bool swapped);

  /// ends the list of a row
  void end_list() { m_first.push_back(values()); }

  /// room for so many values
  void reserve(std::size_t values) { m_bytes.reserve(values * size_of(m_type)); }

 private:
  std::string m_name;
  Value_type m_type;
  Value_type m_count_type = Value_type::uint8;
  std::vector<unsigned char> m_bytes;
  std::vector<std::size_t> m_first;  // rows + 1 for lists, else empty
};

/// Whether an integer lies in the range of an integer type.
bool fits(Value_type type, std::int64_t value);

/// The rows of one kind of thing (vertices, faces, edges, ...) and their columns.
struct Element {
  std::string name;
  std::size_t size = 0;  // rows; every property has as many
  std::vector<Property> properties;
};

/// the property of that name, be it of numbers or of lists, or null
const Property* find_property(const Element& element, std::string_view name);

/// the property of that name that has one number per row, or null
const Property* find_numbers(const Element& element, std::string_view name);

/// the property of that name that has a list per row, or null
const Property* find_list(const Element& element, std::string_view name);

/// Removes the property of that name, if there is one.
void remove_property(Element& element, std::string_view name);

/// Adds a property, in the place of one of the same name if there is one.
/// \pre `property.rows() == element.size`
void set_property(Element& element, Property property);

/// Likewise, for one float or double per row
void set_property(Element& element, const std::string& name, const std::vector<float>& values);
void set_property(Element& element, const std::string& name, const std::vector<double>& values);

}  // namespace conformal
