// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_vtp.h"

#include "Poly_data_builder.h"
#include "inflate_blocks.h"

#include "conformal/io/file/Xml_scanner.h"
#include "conformal/io/file/base64.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/little_endian.h"
#include "conformal/io/file/numbers.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace conformal {
namespace {

std::string unescaped(std::string_view text)
{
  std::string name(text);
  for (const auto& [code, c] :
       {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    for (std::size_t i = name.find(code); i != name.npos; i = name.find(code, i + 1))
      name.replace(i, std::string_view(code).size(), c);
  return name;
}

/// the text in which arrays are, without blanks
std::string without_blanks(std::string_view text)
{
  std::string result;
  for (const char c : text)
    if (c != ' ' && c != '\n' && c != '\r' && c != '\t') result += c;
  return result;
}

class Vtp_reader {
 public:
  Vtp_reader(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
      : m_scanner(bytes.substr(0, bytes.find("<AppendedData")), path),
        m_data(path, File_format::vtp, bad_faces)
  {
    find_appended(bytes);
    while (const auto tag = m_scanner.next()) read(*tag);
    set_faces();
  }

  Surface_file take() { return m_data.take(); }

 private:
  void find_appended(std::string_view bytes)
  {
    const std::size_t at = bytes.find("<AppendedData");
    if (at == bytes.npos) return;
    m_appended = bytes.substr(at);
    m_appended_is_raw = m_appended.substr(0, m_appended.find('>')).find("raw") != m_appended.npos;
    m_appended.remove_prefix(std::min(m_appended.find('_') + 1, m_appended.size()));
  }

  std::string_view attribute(const Xml_tag& tag, const char* name, std::string_view otherwise) const
  {
    return tag.attribute(name).value_or(otherwise);
  }

  std::size_t number(const Xml_tag& tag, const char* name, std::string_view otherwise) const
  {
    const std::string_view word = attribute(tag, name, otherwise);
    const auto value = parse_integer(word);
    if (!value || *value < 0)
      m_scanner.fail(std::string(name) + " is " + in_quotes(word) + ", wanted a number");
    return static_cast<std::size_t>(*value);
  }

  void read(const Xml_tag& tag)
  {
    if (tag.name == "VTKFile" && tag.opens) read_file(tag);
    if (tag.name == "Piece" && tag.opens) read_piece(tag);
    if (tag.name == "DataArray" && tag.opens) read_array(tag);
    const bool is_section = tag.name == "PointData" || tag.name == "CellData" ||
                            tag.name == "Points" || tag.name == "Polys" || tag.name == "Verts" ||
                            tag.name == "Lines" || tag.name == "Strips" || tag.name == "FieldData";
    if (!is_section) return;
    m_section = tag.opens && !tag.closes ? tag.name : "";
    m_normals = attribute(tag, "Normals", "Normals");
    m_texture = attribute(tag, "TCoords", "TCoords");
  }

  void read_file(const Xml_tag& tag)
  {
    if (attribute(tag, "type", "") != "PolyData")
      m_scanner.fail("holds " + in_quotes(attribute(tag, "type", "")) + ", wanted PolyData");
    if (attribute(tag, "byte_order", "LittleEndian") != "LittleEndian")
      m_scanner.fail("is big endian, wanted little endian");
    m_compressor = attribute(tag, "compressor", "");
    m_header = attribute(tag, "header_type", "UInt32") == "UInt64" ? 8 : 4;
  }

  void read_piece(const Xml_tag& tag)
  {
    if (m_has_piece) m_scanner.fail("has more than one piece, wanted one");
    m_has_piece = true;
    for (const char* cells : {"NumberOfVerts", "NumberOfLines", "NumberOfStrips"}) {
      const std::size_t count = number(tag, cells, "0");
      if (count > 0) m_data.leave_out(std::string(cells).substr(8));
      if (std::string_view(cells) != "NumberOfStrips") m_data.skip_cells(count);
    }
  }

  void read_array(const Xml_tag& tag)
  {
    Vtk_array array{unescaped(attribute(tag, "Name", "")), vtk_type(attribute(tag, "type", "")),
                    number(tag, "NumberOfComponents", "1")};
    if (m_section.empty() || m_section == "FieldData" || array.width == 0) return;
    if (array.type == nullptr)
      return m_data.leave_out("an array of " + std::string(attribute(tag, "type", "nothing")));
    array.values = numbers(tag, *array.type);
    if (m_section == "Points")
      m_data.set_points(array.values, tag.line);
    else if (m_section == "Polys")
      (array.name == "offsets" ? m_ends : m_corners) = std::move(array.values);
    else if (m_section == "PointData" || m_section == "CellData")
      add(std::move(array));
  }

  void add(Vtk_array array)
  {
    if (array.name == m_normals) array.name = "Normals";
    if (array.name == m_texture) array.name = "TCoords";
    m_data.add_array(m_section == "PointData", std::move(array));
  }

  std::vector<double> numbers(const Xml_tag& tag, const Vtk_type& type)
  {
    const std::string_view format = attribute(tag, "format", "ascii");
    if (format == "ascii") return text_numbers();
    if (format == "binary")
      return values_in(bytes_in(without_blanks(m_scanner.text()), false), type);
    const std::size_t offset = number(tag, "offset", "0");
    if (offset > m_appended.size()) m_scanner.fail("an array begins behind the end of the file");
    return values_in(bytes_in(m_appended.substr(offset), m_appended_is_raw), type);
  }

  std::vector<double> text_numbers()
  {
    std::vector<double> values;
    std::string_view text = m_scanner.text();
    const std::string_view blanks = " \t\r\n";
    for (;;) {
      text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
      if (text.empty()) return values;
      const std::string_view word = text.substr(0, text.find_first_of(blanks));
      const auto value = parse_double(word);
      if (!value) m_scanner.fail(in_quotes(word) + " is not a number");
      values.push_back(*value);
      text.remove_prefix(word.size());
    }
  }

  /// Bytes from a place of the text on, raw or from base64, in which a stream may begin anew
  std::string part(std::string_view from, bool is_raw, std::size_t size) const
  {
    size = std::min(size, from.size());
    const std::string bytes = is_raw ? std::string(from.substr(0, size))
                                     : from_base64(from.substr(0, length_of(size, false)));
    if (bytes.size() < size) m_scanner.fail("an array ends before its last number");
    return bytes.substr(0, size);
  }

  static std::size_t length_of(std::size_t size, bool is_raw)
  {
    return is_raw ? size : 4 * ((size + 2) / 3);
  }

  /// number i of a header
  std::size_t size_in(std::string_view header, std::size_t i) const
  {
    const char* const at = header.data() + m_header * i;
    return m_header == 8 ? static_cast<std::size_t>(little_endian<std::uint64_t>(at))
                         : little_endian<std::uint32_t>(at);
  }

  /// The bytes of an array: first comes their number, or what there is of compressed blocks.
  std::string bytes_in(std::string_view from, bool is_raw) const
  {
    const std::size_t first = size_in(part(from, is_raw, m_header), 0);
    if (first > from.size()) m_scanner.fail("an array ends before its last number");
    if (m_compressor.empty()) return part(from, is_raw, m_header + first).substr(m_header);
    const std::string header = part(from, is_raw, m_header * (3 + first));
    Packed_blocks blocks{size_in(header, 1), size_in(header, 2), {}};
    std::size_t size = 0;
    for (std::size_t i = 0; i < first; ++i) {
      blocks.packed.push_back(std::min(size_in(header, 3 + i), from.size()));
      size += blocks.packed.back();
    }
    from.remove_prefix(std::min(length_of(header.size(), is_raw), from.size()));
    const auto bytes = inflated(blocks, part(from, is_raw, size));
    if (m_compressor != "vtkZLibDataCompressor" || !bytes)
      m_scanner.fail("is compressed by " + std::string(m_compressor) +
                     " in a way that is not read; try: Compressor Type None where it is written");
    return *bytes;
  }

  static std::vector<double> values_in(const std::string& bytes, const Vtk_type& type)
  {
    std::vector<double> values;
    for (std::size_t i = 0; i + type.size <= bytes.size(); i += type.size)
      values.push_back(type.read(bytes.data() + i));
    return values;
  }

  void set_faces()
  {
    std::vector<double> first = {0};
    first.insert(first.end(), m_ends.begin(), m_ends.end());
    m_data.set_faces(first, m_corners, 0);
  }

  Xml_scanner m_scanner;
  Poly_data_builder m_data;
  std::string_view m_appended;
  std::string_view m_compressor;
  bool m_appended_is_raw = false, m_has_piece = false;
  std::size_t m_header = 4;  // bytes of the size of an array
  std::string_view m_section, m_normals, m_texture;
  std::vector<double> m_ends, m_corners;
};

}  // namespace

Surface_file parse_vtp(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  return Vtp_reader(bytes, path, bad_faces).take();
}

}  // namespace conformal
