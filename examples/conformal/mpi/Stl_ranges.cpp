// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Stl_ranges.h"

#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/little_endian.h"
#include "conformal/process/Failure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <numeric>
#include <tuple>
#include <utility>

namespace conformal::mpi {

/// of a facet; 3 f + c is the number of corner c of facet f
struct Stl_corner {
  std::array<float, 3> place;
  int number;

  bool operator<(const Stl_corner& other) const
  {
    return std::tie(place, number) < std::tie(other.place, other.number);
  }

  std::size_t process() const
  {
    std::size_t hash = 0;
    for (const float x : place) {
      std::uint32_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 29;
    }
    return hash % static_cast<std::size_t>(processes());
  }
};

namespace {

constexpr std::size_t header_size = 84, facet_size = 50;  // bytes

/// the number of facets
int facets_in(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Read_error(path, 0, "it cannot be opened");
  std::array<char, header_size> head{};
  file.read(head.data(), head.size());
  file.clear();
  file.seekg(0, std::ios::end);
  const std::size_t facets = little_endian<std::uint32_t>(head.data() + header_size - 4),
                    most = 715827882;  // corners are counted by int
  if (static_cast<std::size_t>(file.tellg()) != header_size + facet_size * facets)
    throw unsuitable(path,
                     "it is neither binary PLY nor binary STL, as is needed to read it in "
                     "parts; try: conformal compare, or another program, to write it as such");
  if (facets == 0 || facets > most)
    throw unsuitable(
        path, "it has " + std::to_string(facets) + " facets, wanted 1 to " + std::to_string(most));
  return static_cast<int>(facets);
}

std::vector<char> bytes_of(const std::string& path, const Ranges& facets)
{
  std::vector<char> bytes(facet_size * static_cast<std::size_t>(facets.size()));
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(header_size +
                                         facet_size * static_cast<std::size_t>(facets.begin())));
  if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw Read_error(path, 0, "it ends early");
  return bytes;
}

std::vector<Stl_corner> corners_of(const std::vector<char>& bytes, const Ranges& facets,
                                   const std::string& path)
{
  std::vector<Stl_corner> corners;
  corners.reserve(static_cast<std::size_t>(3 * facets.size()));
  for (int f = 0; f < facets.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      const char* const from =
          bytes.data() + facet_size * static_cast<std::size_t>(f) + 12 + 12 * c;
      Stl_corner corner{{}, 3 * (facets.begin() + f) + c};
      for (std::size_t k = 0; k < 3; ++k) {
        corner.place[k] = little_endian<float>(from + 4 * k) + 0.f;  // no -0
        if (!std::isfinite(corner.place[k]))
          throw unsuitable(
              path, "a coordinate is not finite at facet " + std::to_string(facets.begin() + f));
      }
      corners.push_back(corner);
    }
  return corners;
}

/// for each corner, the first one at its place
std::vector<int> first_ones(const std::vector<Stl_corner>& corners)
{
  return ask(
      corners, [](const Stl_corner& corner) { return corner.process(); },
      [](const std::vector<Stl_corner>& asked) {
        std::vector<std::size_t> order(asked.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return asked[a] < asked[b]; });
        std::vector<int> first(asked.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
          const bool is_first = k == 0 || asked[order[k]].place != asked[order[k - 1]].place;
          first[order[k]] = is_first ? asked[order[k]].number : first[order[k - 1]];
        }
        return first;
      });
}

template <class T>
void append(const T& value, std::vector<std::byte>& bytes)
{
  const auto* const first = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

}  // namespace

/// the rows of the PLY file
struct Stl_ranges::Table {
  int vertices = 0, facets = 0;
  bool has_attributes = false;
  std::vector<std::byte> vertex_rows, face_rows;  // of the equal ranges of this process

  explicit Table(const std::string& path)
  {
    together([&] { facets = facets_in(path); });
    const Ranges range = Ranges::equal(facets);
    std::vector<char> bytes;
    std::vector<Stl_corner> corners;
    together([&] {
      bytes = bytes_of(path, range);
      corners = corners_of(bytes, range, path);
    });
    add_faces(bytes, range, add_vertices(corners, range), path);
  }

 private:
  // The vertices of the corners: the first ones, in their order
  std::vector<int> add_vertices(const std::vector<Stl_corner>& corners, const Ranges& range)
  {
    struct Vertex {
      int number;
      std::array<float, 3> place;
    };
    const std::vector<int> first = first_ones(corners);
    const auto is_first = [&](std::size_t k) { return first[k] == corners[k].number; };
    int own = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) own += is_first(k) ? 1 : 0;
    const Ranges numbers = Ranges::of(own), equal = Ranges::equal(numbers.total());
    vertices = numbers.total();
    std::vector<int> names(corners.size(), -1);
    std::vector<std::vector<Vertex>> to(static_cast<std::size_t>(processes()));
    int next = numbers.begin();
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (is_first(k)) {
        to[equal.owner(next)].push_back({next, corners[k].place});
        names[k] = next++;
      }
    for (const Vertex& vertex : deliver(to)) append(vertex.place, vertex_rows);  // in order
    Ranges of_corners = range;
    for (int& begin : of_corners.first) begin *= 3;
    return look_up(first, of_corners, names);
  }

  void add_faces(const std::vector<char>& bytes, const Ranges& range,
                 const std::vector<int>& corners, const std::string& path)
  {
    const auto attribute = [&](std::size_t f) {
      return little_endian<std::uint16_t>(bytes.data() + facet_size * f + facet_size - 2);
    };
    const auto own = static_cast<std::size_t>(range.size());
    bool is_set = false;
    for (std::size_t f = 0; f < own; ++f) is_set = is_set || attribute(f) != 0;
    has_attributes = largest(is_set ? 1 : 0) > 0;
    together([&] {
      for (std::size_t f = 0; f < own; ++f) {
        const std::array<int, 3> v{corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]};
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
          throw unsuitable(path, "facet " + std::to_string(range.begin() + static_cast<int>(f)) +
                                     " has two equal corners; try: conformal spin --repair");
        append(std::uint8_t{3}, face_rows);
        append(v, face_rows);
        if (has_attributes) append(attribute(f), face_rows);
      }
    });
  }
};

namespace {

Ply_header header_of(int vertices, int facets, bool has_attributes)
{
  Ply_header header;
  header.encoding = Ply_encoding::little_endian;
  Element vertex{"vertex", static_cast<std::size_t>(vertices), {}},
      face{"face", static_cast<std::size_t>(facets), {}};
  for (const char* const name : {"x", "y", "z"})
    vertex.properties.emplace_back(name, Value_type::float32);
  face.properties.emplace_back("vertex_indices", Value_type::uint8, Value_type::int32);
  if (has_attributes) face.properties.emplace_back("attribute", Value_type::uint16);
  header.elements = {std::move(vertex), std::move(face)};
  return header;
}

}  // namespace

Stl_ranges::Stl_ranges(const std::string& path) : Stl_ranges(path, Table(path)) {}

Stl_ranges::Stl_ranges(const std::string& path, Table table)
    : Ply_ranges(path, header_of(table.vertices, table.facets, table.has_attributes)),
      m_vertices{vertex_row(Ranges::equal(table.vertices).begin()), std::move(table.vertex_rows)},
      m_faces{face_row(Ranges::equal(table.facets).begin()), std::move(table.face_rows)}
{}

void Stl_ranges::read(std::size_t begin, std::vector<std::byte>& bytes) const
{
  const Block& block = begin < face_row(0) ? m_vertices : m_faces;
  const auto first = block.bytes.begin() + static_cast<std::ptrdiff_t>(begin - block.begin);
  std::copy_n(first, bytes.size(), bytes.begin());
}

std::unique_ptr<const Ply_ranges> surface_ranges(const std::string& path)
{
  bool is_ply = false;
  together([&] {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Read_error(path, 0, "it cannot be opened");
    std::string word(3, ' ');
    file.read(word.data(), 3);
    is_ply = word == "ply";
  });
  if (!is_ply) return std::make_unique<Stl_ranges>(path);
  std::unique_ptr<const Ply_ranges> file;
  together([&] { file = std::make_unique<Ply_ranges>(path); });
  return file;
}

}  // namespace conformal::mpi
