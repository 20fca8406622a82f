// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Ply_body.h"

#include "conformal/io/file/Text_scanner.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/little_endian.h"
#include "conformal/io/file/numbers.h"

namespace conformal {
namespace {

// Reads values from text. Rows are not bound to lines, as in the programs that read such files.
class Ascii_source {
 public:
  Ascii_source(std::string_view bytes, const std::string& path, std::size_t line,
               std::vector<std::string>* notes)
      : m_scanner(bytes, path, Text_scanner::plain, line), m_notes(notes)
  {}

  // a digit and a blank
  static std::size_t least_size(Value_type) { return 2; }

  // of the values left; the last one needs no blank
  std::size_t bytes_left() const { return m_scanner.bytes_left() + 1; }

  void begin_row(Ply_element& element, std::size_t)
  {
    if (m_scanner.at_end()) m_scanner.fail("the file ends, wanted element " + element.name);
    element.lines.push_back(m_scanner.line());
  }

  std::int64_t read_count(const Property& property)
  {
    const std::int64_t count = m_scanner.integer("the length of a list");
    if (!fits(property.count_type(), count)) fail_range(count, property.count_type());
    return count;
  }

  void read_value(Property& property)
  {
    if (is_integer(property.type())) {
      const std::int64_t value = m_scanner.integer("a value");
      if (!fits(property.type(), value)) fail_range(value, property.type());
      property.append(static_cast<double>(value));
    } else {
      property.append(read_real(property.type()));
    }
  }

  [[noreturn]] void fail(const std::string& message) const { m_scanner.fail(message); }

  // Values that the header does not announce are left out only where a note can be made.
  void end_row(std::size_t row)
  {
    if (m_notes == nullptr) return;
    std::size_t surplus = 0;
    for (; !m_scanner.at_end_of_line(); ++surplus) m_scanner.number("a number");
    if (row == 0) m_surplus = surplus;
    if (surplus != m_surplus) m_scanner.fail("a line of another length");
  }

  void end_element(const Element& element)
  {
    if (m_notes != nullptr && element.size != 0 && m_surplus != 0)
      m_notes->push_back("each " + element.name + " has " + std::to_string(m_surplus) +
                         " values that the header does not announce; they were left out");
  }

  void finish()
  {
    if (!m_scanner.at_end())
      m_scanner.fail(in_quotes(m_scanner.word("")) + " after the last element, wanted the end");
  }

 private:
  // A float is rounded from its digits once: through double it would be rounded twice.
  double read_real(Value_type type)
  {
    const std::string_view word = m_scanner.word("a number");
    const std::optional<double> value =
        type == Value_type::float64 ? parse_double(word) : std::optional<double>(parse_float(word));
    if (!value) m_scanner.fail(in_quotes(word) + " is not a number, wanted a number");
    return *value;
  }

  [[noreturn]] void fail_range(std::int64_t value, Value_type type) const
  {
    m_scanner.fail(std::to_string(value) + " is out of the range of the type " +
                   std::string(name_of(type)));
  }

  Text_scanner m_scanner;
  std::vector<std::string>* m_notes;
  std::size_t m_surplus = 0;  // values at the end of the first row's line
};

class Binary_source {
 public:
  Binary_source(std::string_view bytes, const std::string& path, bool is_little_endian)
      : m_bytes(bytes), m_path(path), m_is_swapped(is_little_endian != machine_is_little_endian)
  {}

  static std::size_t least_size(Value_type type) { return size_of(type); }
  std::size_t bytes_left() const { return m_bytes.size(); }

  void end_row(std::size_t) {}
  void end_element(const Element&) {}

  void begin_row(const Ply_element& element, std::size_t row)
  {
    m_element = element.name.c_str();
    m_row = row;
  }

  std::int64_t read_count(const Property& property)
  {
    Property count("", property.count_type());
    read_value(count);
    return count.integer(0);
  }

  void read_value(Property& property)
  {
    const std::size_t size = size_of(property.type());
    if (size > m_bytes.size()) fail("the file ends, wanted a value of " + property.name());
    property.append_bytes(reinterpret_cast<const unsigned char*>(m_bytes.data()), m_is_swapped);
    m_bytes.remove_prefix(size);
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Read_error(m_path, 0,
                     std::string(m_element) + ' ' + std::to_string(m_row) + ": " + message);
  }

  void finish() const
  {
    if (m_bytes.find_first_not_of(" \t\r\n") != std::string_view::npos)
      throw Read_error(
          m_path, 0,
          std::to_string(m_bytes.size()) + " bytes after the last element, wanted the end");
  }

 private:
  std::string_view m_bytes;
  const std::string& m_path;
  bool m_is_swapped;
  const char* m_element = "";
  std::size_t m_row = 0;
};

template <class Source>
void check_size(const Source& source, const Element& element, const std::string& path,
                std::size_t line)
{
  std::size_t row = 0;
  for (const Property& property : element.properties)
    row += Source::least_size(property.is_list() ? property.count_type() : property.type());
  if (row != 0 && element.size > source.bytes_left() / row)
    throw Read_error(path, line,
                     std::to_string(element.size) + ' ' + element.name + " elements, but the " +
                         std::to_string(source.bytes_left()) + " bytes left hold at most " +
                         std::to_string(source.bytes_left() / row));
}

template <class Source>
void read_list(Source& source, Property& property)
{
  const std::int64_t count = source.read_count(property);
  const std::size_t most = source.bytes_left() / Source::least_size(property.type());
  if (count < 0 || static_cast<std::size_t>(count) > most)
    source.fail("a list " + property.name() + " of " + std::to_string(count) +
                " values, wanted at most " + std::to_string(most) + ", which the bytes left hold");
  for (std::int64_t i = 0; i < count; ++i) source.read_value(property);
  property.end_list();
}

template <class Source>
std::vector<Ply_element> read_elements(Source source, const std::string& path,
                                       const Ply_header& header)
{
  std::vector<Ply_element> elements;
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    Ply_element element{header.elements[e], {}};
    check_size(source, element, path, header.element_lines[e]);
    for (Property& property : element.properties)
      if (!property.is_list()) property.reserve(element.size);
    const std::size_t rows = element.properties.empty() ? 0 : element.size;
    for (std::size_t row = 0; row < rows; ++row) {
      source.begin_row(element, row);
      for (Property& property : element.properties)
        property.is_list() ? read_list(source, property) : source.read_value(property);
      source.end_row(row);
    }
    source.end_element(element);
    elements.push_back(std::move(element));
  }
  source.finish();
  return elements;
}

std::vector<Ply_element> read_ascii(std::string_view bytes, const std::string& path,
                                    const Ply_header& header, std::vector<std::string>& notes)
{
  try {
    return read_elements(Ascii_source(bytes, path, header.lines + 1, nullptr), path, header);
  } catch (const Read_error&) {
    try {
      return read_elements(Ascii_source(bytes, path, header.lines + 1, &notes), path, header);
    } catch (const Read_error&) {
    }
    throw;  // the first one, which takes the file at its word
  }
}

}  // namespace

std::vector<Ply_element> parse_ply_body(std::string_view bytes, const std::string& path,
                                        const Ply_header& header, std::vector<std::string>& notes)
{
  bytes.remove_prefix(header.bytes);
  if (header.encoding == Ply_encoding::ascii) return read_ascii(bytes, path, header, notes);
  const bool is_little_endian = header.encoding == Ply_encoding::little_endian;
  return read_elements(Binary_source(bytes, path, is_little_endian), path, header);
}

}  // namespace conformal
