// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Ply_ranges.h"

#include "Common_file.h"

#include "conformal/io/file/io_errors.h"
#include "conformal/process/Failure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace conformal::mpi {
namespace {

const std::size_t rows_at_once = 65536;

template <class T>
double as(const std::byte* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double number(Value_type type, const std::byte* bytes)
{
  switch (type) {
    case Value_type::int8:
      return as<std::int8_t>(bytes);
    case Value_type::uint8:
      return as<std::uint8_t>(bytes);
    case Value_type::int16:
      return as<std::int16_t>(bytes);
    case Value_type::uint16:
      return as<std::uint16_t>(bytes);
    case Value_type::int32:
      return as<std::int32_t>(bytes);
    case Value_type::uint32:
      return as<std::uint32_t>(bytes);
    case Value_type::float32:
      return as<float>(bytes);
    default:
      return as<double>(bytes);
  }
}

void append(const void* bytes, std::size_t size, std::vector<char>& to)
{
  const char* const first = static_cast<const char*>(bytes);
  to.insert(to.end(), first, first + size);
}

bool is_normal(const std::string& name)
{
  return name == "nx" || name == "ny" || name == "nz";
}

/// of a file
Ply_header ply_header(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Read_error(path, 0, "it cannot be opened");
  const std::size_t longest_header = 1 << 20;
  std::string start(longest_header, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  return parse_ply_header(start, path);
}

}  // namespace

Ply_ranges::Ply_ranges(std::string path) : Ply_ranges(path, ply_header(path))
{
  std::ifstream file(m_path, std::ios::binary | std::ios::ate);
  if (static_cast<std::size_t>(file.tellg()) < m_face.begin + m_face.count * m_face.stride)
    refuse("it is too short for triangles only");
}

Ply_ranges::Ply_ranges(std::string path, Ply_header header)
    : m_path(std::move(path)), m_header(std::move(header))
{
  const std::vector<Element>& elements = m_header.elements;
  if (m_header.encoding != Ply_encoding::little_endian || elements.size() < 2 ||
      elements[0].name != "vertex" || elements[1].name != "face")
    refuse("it is not binary (little endian) with vertices first and faces next");
  place_vertices(elements[0]);
  place_faces(elements[1]);
}

void Ply_ranges::read(std::size_t begin, std::vector<std::byte>& bytes) const
{
  std::ifstream file(m_path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(begin));
  if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    throw Read_error(m_path, 0, "it ends early");
}

void Ply_ranges::refuse(const std::string& what) const
{
  throw unsuitable(m_path, what +
                               ", as is needed to read it in parts; try: conformal compare, or "
                               "another program, to write it as binary PLY with triangles");
}

void Ply_ranges::place_vertices(const Element& element)
{
  m_vertex = {element.size, m_header.bytes, 0};
  for (const Property& property : element.properties) {
    if (property.is_list()) refuse("its vertices have a list, " + property.name());
    m_places.push_back({property.name(), property.type(), m_vertex.stride});
    m_vertex.stride += size_of(property.type());
  }
  const char* const names[] = {"x", "y", "z"};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto place = std::find_if(m_places.begin(), m_places.end(),
                                    [&](const Place& p) { return p.name == names[c]; });
    if (place == m_places.end()) refuse(std::string("its vertices have no ") + names[c]);
    m_xyz[c] = *place;
  }
}

void Ply_ranges::place_faces(const Element& element)
{
  m_face = {element.size, m_vertex.begin + m_vertex.count * m_vertex.stride, 0};
  int lists = 0;
  for (const Property& property : element.properties) {
    if (!property.is_list()) {
      m_face.stride += size_of(property.type());
      continue;
    }
    const bool has_four_bytes =
        property.type() == Value_type::int32 || property.type() == Value_type::uint32;
    if (++lists > 1 || size_of(property.count_type()) != 1 || !has_four_bytes)
      refuse("the lists of its faces are not one of corners, int after uchar");
    m_corners = m_face.stride;
    m_face.stride += 1 + 3 * 4;
  }
  if (lists == 0) refuse("its faces have no corners");
}

void Ply_ranges::for_each_row(const Rows& rows, int first, int last,
                              const std::function<void(int, const std::byte*)>& visit) const
{
  std::vector<std::byte> some;
  for (int row = first; row < last;) {
    const auto count = (std::min)(rows_at_once, static_cast<std::size_t>(last - row));
    some.resize(count * rows.stride);
    read(rows.at(row), some);
    for (std::size_t k = 0; k < count; ++k) visit(row++, some.data() + k * rows.stride);
  }
}

CGP::Points Ply_ranges::positions(int first, int last) const
{
  CGP::Points p(3, last - first);
  for_each_row(m_vertex, first, last, [&](int v, const std::byte* row) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      const Place& place = m_xyz[static_cast<std::size_t>(c)];
      p(c, v - first) = number(place.type, row + place.offset);
    }
    if (!p.col(v - first).allFinite())
      throw unsuitable(m_path, "a coordinate is not finite at vertex " + std::to_string(v));
  });
  return p;
}

std::vector<std::array<int, 3>> Ply_ranges::corners(int first, int last) const
{
  std::vector<std::array<int, 3>> all;
  all.reserve(static_cast<std::size_t>(last - first));
  for_each_row(m_face, first, last, [&](int f, const std::byte* row) {
    if (std::to_integer<int>(row[m_corners]) != 3)
      refuse("face " + std::to_string(f) + " is not a triangle");
    std::array<int, 3> corners;
    std::memcpy(corners.data(), row + m_corners + 1, sizeof corners);
    for (const int v : corners)
      if (v < 0 || v >= vertices())
        throw unsuitable(m_path, "face " + std::to_string(f) + " has a corner " +
                                     std::to_string(v) + ", which is not a vertex");
    all.push_back(corners);
  });
  return all;
}

std::vector<std::string> Ply_ranges::left_out() const
{
  std::vector<std::string> names;
  if (std::any_of(m_places.begin(), m_places.end(),
                  [](const Place& p) { return is_normal(p.name); }))
    names.emplace_back("normals, which are not those of the new surface");
  for (std::size_t e = 2; e < m_header.elements.size(); ++e)
    names.push_back("the element " + m_header.elements[e].name);
  return names;
}

std::vector<Ply_ranges::Place> Ply_ranges::kept(const std::vector<Column>& columns) const
{
  std::vector<Place> places;
  for (const Place& place : m_places) {
    const bool is_replaced =
        place.name == "x" || place.name == "y" || place.name == "z" || is_normal(place.name) ||
        std::any_of(columns.begin(), columns.end(),
                    [&](const Column& column) { return column.name == place.name; });
    if (!is_replaced) places.push_back(place);
  }
  return places;
}

std::string Ply_ranges::header(const std::vector<Place>& kept,
                               const std::vector<Column>& columns) const
{
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : m_header.comments) text += "comment " + comment + "\n";
  text += "element vertex " + std::to_string(m_vertex.count) + "\n";
  for (const char* const name : {"x", "y", "z"})
    text += std::string("property double ") + name + "\n";
  for (const Place& place : kept)
    text += "property " + std::string(name_of(place.type)) + " " + place.name + "\n";
  for (const Column& column : columns) text += "property double " + column.name + "\n";
  text += "element face " + std::to_string(m_face.count) + "\n";
  for (const Property& property : m_header.elements[1].properties) {
    const std::string type(name_of(property.type()));
    text +=
        "property " +
        (property.is_list() ? "list " + std::string(name_of(property.count_type())) + " " : "") +
        type + " " + property.name() + "\n";
  }
  return text + "end_header\n";
}

void Ply_ranges::write(const std::string& path, const Ranges& ranges, const CGP::Points& positions,
                       const std::vector<Column>& columns) const
{
  const std::vector<Place> carried = kept(columns);
  const std::string head = header(carried, columns);
  std::size_t stride = sizeof(double) * (3 + columns.size());
  for (const Place& place : carried) stride += size_of(place.type);
  Common_file file(path);
  // Rows are written by the thousands, from `begin` on.
  const auto copy =
      [&](const Rows& rows, const Ranges& range, std::size_t begin, std::size_t size,
          const std::function<void(int, const std::byte*, std::vector<char>&)>& fill) {
        std::vector<char> bytes;
        int first = range.begin();
        const auto flush = [&](int next) {
          file.write_at(begin + size * static_cast<std::size_t>(first), bytes);
          bytes.clear();
          first = next;
        };
        for_each_row(rows, range.begin(), range.end(), [&](int row, const std::byte* old) {
          fill(row, old, bytes);
          if (bytes.size() >= rows_at_once * size) flush(row + 1);
        });
        flush(range.end());
      };
  together([&] {
    if (rank() == 0) file.write_at(0, {head.begin(), head.end()});
    copy(m_vertex, ranges, head.size(), stride,
         [&](int v, const std::byte* old, std::vector<char>& bytes) {
           const int k = v - ranges.begin();
           append(positions.col(k).data(), 3 * sizeof(double), bytes);
           for (const Place& place : carried)
             append(old + place.offset, size_of(place.type), bytes);
           for (const Column& column : columns)
             append(&column.values[static_cast<std::size_t>(k)], sizeof(double), bytes);
         });
    copy(m_face, Ranges::equal(faces()), head.size() + stride * m_vertex.count, m_face.stride,
         [&](int, const std::byte* old, std::vector<char>& bytes) {
           append(old, m_face.stride, bytes);
         });
  });
  file.commit();
}

}  // namespace conformal::mpi
