// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Ply_header.h"

#include "conformal/io/file/Text_scanner.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/numbers.h"

namespace conformal {
namespace {

std::string_view without_trailing_blanks(std::string_view line)
{
  return line.substr(0, line.find_last_not_of(" \t") + 1);
}

class Header_reader {
 public:
  Header_reader(std::string_view bytes, const std::string& path) : m_bytes(bytes), m_path(path)
  {
    if (without_trailing_blanks(next_line()) != "ply")
      fail("the first line is not ply, wanted a PLY file");
    bool has_format = false;
    for (std::string_view line = next_line(); without_trailing_blanks(line) != "end_header";
         line = next_line()) {
      Text_scanner words(line, path, Text_scanner::plain, m_header.lines);
      if (words.at_end()) continue;
      const std::string_view keyword = words.word("");
      if (keyword == "comment" || keyword == "obj_info") {
        keep(keyword, line);
        continue;
      }
      read_line(keyword, words, has_format);
      if (!words.at_end()) fail(in_quotes(words.word("")) + " ends the line, wanted nothing there");
    }
    if (!has_format) fail("no format line in the header, wanted format ascii 1.0 or the like");
  }

  Ply_header take() { return std::move(m_header); }

 private:
  [[noreturn]] void fail(const std::string& message) const
  {
    throw Read_error(m_path, m_header.lines, message);
  }

  // Each line ends in its own way, since programs that copy headers mix them. After a line that
  // ends with CR alone, an LF behind CR is not part of the line end: it may be the first of the
  // data.
  std::string_view next_line()
  {
    const std::size_t end = m_bytes.find_first_of("\r\n", m_header.bytes);
    ++m_header.lines;
    if (end == std::string_view::npos) fail("the file ends in the header, wanted end_header");
    const bool is_two = !m_only_cr && m_bytes.substr(end, 2) == "\r\n";
    m_only_cr = m_bytes[end] == '\r' && !is_two;
    const std::string_view line = m_bytes.substr(m_header.bytes, end - m_header.bytes);
    m_header.bytes = end + (is_two ? 2 : 1);
    return line;
  }

  void keep(std::string_view keyword, std::string_view line)
  {
    const std::size_t begin = line.find(keyword) + keyword.size();
    const std::string text(line.substr(std::min(begin + 1, line.size())));
    (keyword == "comment" ? m_header.comments : m_header.object_info).push_back(text);
  }

  void read_line(std::string_view keyword, Text_scanner& words, bool& has_format)
  {
    if (keyword == "format") {
      if (has_format) fail("a second format line, wanted one");
      read_format(words);
      has_format = true;
    } else if (keyword == "element") {
      read_element(words);
    } else if (keyword == "property") {
      read_property(words);
    } else {
      fail(in_quotes(keyword) +
           ", wanted format, element, property, comment, obj_info or end_header");
    }
  }

  void read_format(Text_scanner& words)
  {
    const std::string_view name = words.word("ascii or binary_...");
    if (name == "ascii")
      m_header.encoding = Ply_encoding::ascii;
    else if (name == "binary_little_endian")
      m_header.encoding = Ply_encoding::little_endian;
    else if (name == "binary_big_endian")
      m_header.encoding = Ply_encoding::big_endian;
    else
      fail("the format " + in_quotes(name) +
           ", wanted ascii, binary_little_endian or binary_big_endian");
    const std::string_view version = words.word("1.0");
    if (version != "1.0") fail("the version " + in_quotes(version) + ", wanted 1.0");
  }

  void read_element(Text_scanner& words)
  {
    Element element{std::string(words.word("the name of an element")), 0, {}};
    const std::int64_t size = words.integer("the number of elements");
    if (size < 0) fail(std::to_string(size) + ' ' + element.name + " elements, wanted a count");
    for (const Element& other : m_header.elements)
      if (other.name == element.name)
        fail("the element " + in_quotes(element.name) + " comes twice");
    element.size = static_cast<std::size_t>(size);
    m_header.elements.push_back(std::move(element));
    m_header.element_lines.push_back(m_header.lines);
  }

  Value_type read_type(Text_scanner& words)
  {
    const std::string_view name = words.word("a type");
    const auto type = value_type(name);
    if (!type) fail("the type " + in_quotes(name) + ", wanted char, uchar, ..., float or double");
    return *type;
  }

  void read_property(Text_scanner& words)
  {
    if (m_header.elements.empty()) fail("a property before the first element");
    Text_scanner ahead = words;
    const bool is_list = ahead.word("a type") == "list";
    if (is_list) words.word("list");
    const Value_type count_type = is_list ? read_type(words) : Value_type::uint8;
    if (!is_integer(count_type))
      fail("the length of a list is not an integer, wanted uchar or the like");
    const Value_type type = read_type(words);
    const std::string name(words.word("the name of a property"));
    if (!is_property_name(name))
      fail("the property " + in_quotes(name) + " has blanks in its name");
    Element& element = m_header.elements.back();
    if (find_property(element, name) != nullptr)
      fail("the property " + in_quotes(name) + " comes twice, wanted different names");
    if (is_list)
      element.properties.emplace_back(name, count_type, type);
    else
      element.properties.emplace_back(name, type);
  }

  std::string_view m_bytes;
  bool m_only_cr = false;  // the line before ends so
  const std::string& m_path;
  Ply_header m_header;
};

}  // namespace

Ply_header parse_ply_header(std::string_view bytes, const std::string& path)
{
  return Header_reader(bytes, path).take();
}

}  // namespace conformal
