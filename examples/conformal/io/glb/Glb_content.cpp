// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Glb_content.h"

#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/little_endian.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

namespace conformal {
namespace {

/// the size of a number, and its value as a double
struct Component_type {
  std::size_t size;
  double (*read)(const char* bytes, bool is_normalized);
};

template <class Number>
double read_number(const char* bytes, bool is_normalized)
{
  const auto value = static_cast<double>(little_endian<Number>(bytes));
  if (!is_normalized || !std::numeric_limits<Number>::is_integer) return value;
  return std::max(value / static_cast<double>(std::numeric_limits<Number>::max()), -1.);
}

template <class Number>
Component_type component_type()
{
  return {sizeof(Number), read_number<Number>};
}

Component_type component_type(int number)
{
  static const std::map<int, Component_type> all = {
      {5120, component_type<std::int8_t>()},   {5121, component_type<std::uint8_t>()},
      {5122, component_type<std::int16_t>()},  {5123, component_type<std::uint16_t>()},
      {5125, component_type<std::uint32_t>()}, {5126, component_type<float>()}};
  return all.at(number);
}

std::size_t dimension(const std::string& type)
{
  static const std::map<std::string, std::size_t> all = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  return all.at(type);
}

/// Takes a chunk of the type from the beginning of the bytes.
std::string_view take_chunk(std::string_view& bytes, std::string_view type)
{
  if (bytes.size() < 8 || bytes.substr(4, 4) != type) return {};
  const std::size_t size = little_endian<std::uint32_t>(bytes.data());
  const std::string_view chunk = bytes.substr(8, size);
  if (chunk.size() < size) return {};
  bytes.remove_prefix(8 + size);
  return chunk;
}

}  // namespace

Glb_content::Glb_content(std::string_view bytes, const std::string& path) : m_path(path)
{
  if (bytes.size() < 12 || little_endian<std::uint32_t>(bytes.data() + 4) != 2)
    throw Read_error(path, 0, "is not a GLB file of version 2");
  bytes.remove_prefix(12);
  const std::string_view text = take_chunk(bytes, "JSON");
  if (text.empty()) throw Read_error(path, 0, "is not a whole GLB file: the JSON chunk is cut off");
  m_json = nlohmann::json::parse(text);
  m_binary = take_chunk(bytes, std::string_view("BIN\0", 4));
  if (m_json.contains("extensionsRequired") && !m_json["extensionsRequired"].empty())
    throw Read_error(path, 0,
                     "needs the extension " + m_json["extensionsRequired"][0].get<std::string>() +
                         ", wanted GLB without extensions");
}

std::string_view Glb_content::view(std::size_t index) const
{
  const nlohmann::json& view = m_json.at("bufferViews").at(index);
  const std::size_t begin = view.value("byteOffset", std::size_t{0});
  const std::size_t size = view.at("byteLength").get<std::size_t>();
  if (view.at("buffer").get<int>() != 0 || begin > m_binary.size() ||
      size > m_binary.size() - begin)
    throw Read_error(m_path, 0,
                     "is not a whole GLB file: buffer view " + std::to_string(index) +
                         " is not in its binary chunk");
  return m_binary.substr(begin, size);
}

std::vector<std::array<double, 4>> Glb_content::rows(std::size_t accessor) const
{
  const nlohmann::json& table = m_json.at("accessors").at(accessor);
  const std::size_t index = table.at("bufferView").get<std::size_t>();
  const std::string_view bytes = view(index);
  const Component_type component = component_type(table.at("componentType").get<int>());
  const std::size_t width = dimension(table.at("type").get<std::string>());
  const std::size_t begin = table.value("byteOffset", std::size_t{0});
  const std::size_t count = table.at("count").get<std::size_t>(), size = width * component.size;
  const std::size_t stride = m_json["bufferViews"][index].value("byteStride", size);
  const bool fits = stride > 0 && count <= bytes.size() / stride + 1 && begin <= bytes.size() &&
                    (count == 0 || stride * (count - 1) + size <= bytes.size() - begin);
  if (!fits || table.contains("sparse"))
    throw Read_error(m_path, 0,
                     "accessor " + std::to_string(accessor) +
                         " does not fit into its buffer view, or is sparse");
  const bool is_normalized = table.value("normalized", false);
  std::vector<std::array<double, 4>> rows(count, {0, 0, 0, 0});
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < width; ++k)
      rows[i][k] =
          component.read(bytes.data() + begin + stride * i + component.size * k, is_normalized);
  return rows;
}

}  // namespace conformal
