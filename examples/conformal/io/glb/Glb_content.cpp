// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Glb_content.h"

#include "conformal/io/file/base64.h"
#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/little_endian.h"
#include "conformal/io/file/numbers.h"
#include "conformal/io/file/read_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace conformal {

/// how the numbers of a table are stored
struct Glb_numbers {
  std::size_t size;  // bytes of one
  double (*read)(const char* bytes, bool is_normalized);
  std::size_t width = 1;  // numbers in a row
  bool is_normalized = false;
};

namespace {

using Json = nlohmann::json;

template <class Number>
double read_number(const char* bytes, bool is_normalized)
{
  const auto value = static_cast<double>(little_endian<Number>(bytes));
  if (!is_normalized || !std::numeric_limits<Number>::is_integer) return value;
  return std::max(value / static_cast<double>(std::numeric_limits<Number>::max()), -1.);
}

template <class Number>
Glb_numbers numbers()
{
  return {sizeof(Number), read_number<Number>};
}

// null where the type is unknown
const Glb_numbers* find_numbers(std::size_t type)
{
  static const std::map<std::size_t, Glb_numbers> all = {
      {5120, numbers<std::int8_t>()},   {5121, numbers<std::uint8_t>()},
      {5122, numbers<std::int16_t>()},  {5123, numbers<std::uint16_t>()},
      {5125, numbers<std::uint32_t>()}, {5126, numbers<float>()}};
  const auto found = all.find(type);
  return found == all.end() ? nullptr : &found->second;
}

// 0 where the type is unknown
std::size_t width_of(const std::string& type)
{
  const std::array<const char*, 4> names = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto found = std::find(names.begin(), names.end(), type);
  return found == names.end() ? 0 : static_cast<std::size_t>(found - names.begin()) + 1;
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

/// a file in the folder of another
std::string beside(const std::string& path, const std::string& name)
{
  return path.substr(0, path.find_last_of('/') + 1) + name;
}

}  // namespace

// Conversion to an integer by the library is undefined for what exceeds its range.
std::size_t whole_number(const Json& value)
{
  const double most = 1e15;  // has a bit for 1
  const double x = value.is_number_float() ? value.get<double>() : -1;
  if (x >= 0 && x <= most && x == std::floor(x)) return static_cast<std::size_t>(x);
  return value.get_ref<const Json::number_unsigned_t&>();
}

std::size_t whole_number(const Json& object, const char* key, std::size_t otherwise)
{
  return object.contains(key) ? whole_number(object.at(key)) : otherwise;
}

void Glb_content::fail(const std::string& message) const
{
  throw Read_error(m_path, 0, message);
}

void Glb_content::refuse_item() const
{
  fail("is not a GLB file: " + m_item + " is not as glTF 2.0 defines it");
}

Glb_content::Glb_content(std::string_view bytes, const std::string& path)
    : m_path(path), m_size(bytes.size())
{
  m_is_text = !starts_with(bytes, "glTF");
  m_is_text ? read_description(bytes) : read_chunks(bytes);
}

void Glb_content::read_chunks(std::string_view bytes)
{
  if (bytes.size() < 12 || little_endian<std::uint32_t>(bytes.data() + 4) != 2)
    fail("is not a GLB file of version 2");
  bytes.remove_prefix(12);
  const std::string_view text = take_chunk(bytes, "JSON");
  if (text.empty()) fail("is not a whole GLB file: the JSON chunk is cut off");
  m_binary = take_chunk(bytes, std::string_view("BIN\0", 4));
  read_description(text);
}

void Glb_content::read_description(std::string_view text)
{
  try {
    m_json = Json::parse(text);
    if (!m_json.is_object()) refuse_item();
    check_extensions();
    decode_buffers();
  } catch (const Json::parse_error& error) {
    fail("is not a GLB file: byte " + std::to_string(error.byte) +
         " of its JSON chunk is not as JSON defines it");
  } catch (const Json::exception&) {
    refuse_item();
  }
}

// Those of materials concern looks, which are left out; quantized numbers are read as any.
void Glb_content::check_extensions() const
{
  for (const Json& extension : m_json.value("extensionsRequired", Json::array())) {
    const auto name = extension.get<std::string>();
    if (name != "KHR_mesh_quantization" && !starts_with(name, "KHR_materials_") &&
        !starts_with(name, "KHR_texture_") && !starts_with(name, "KHR_lights_"))
      fail("needs the extension " + name + ", wanted GLB without extensions");
  }
}

void Glb_content::decode_buffers()
{
  const std::size_t count = m_json.value("buffers", Json::array()).size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto uri = item("buffers", i).value("uri", std::string());
    const std::size_t comma = starts_with(uri, "data:") ? uri.find(";base64,") : uri.npos;
    // Of others only files beside it are read: nothing that a mesh names elsewhere.
    const bool is_beside = m_is_text && !uri.empty() && uri.find_first_of("/\\:%") == uri.npos;
    m_decoded.push_back(comma != uri.npos ? from_base64(uri.substr(comma + 8))
                        : is_beside       ? read_bytes(beside(m_path, uri))
                                          : "");
  }
}

const Json& Glb_content::item(const std::string& list, std::size_t index) const
{
  m_item = list + '[' + std::to_string(index) + ']';
  const auto found = m_json.find(list);
  if (found == m_json.end() || !found->is_array() || index >= found->size())
    fail("is not a whole GLB file: " + m_item + " is not there");
  return (*found)[index];
}

std::string_view Glb_content::buffer(std::size_t index) const
{
  const Json& buffer = item("buffers", index);
  if (!buffer.contains("uri")) return m_binary;
  if (m_decoded[index].empty())
    fail(m_item + " is at " + in_quotes(buffer["uri"].get<std::string>()) +
         ", wanted a GLB file that holds all its data");
  return m_decoded[index];
}

std::string_view Glb_content::view(std::size_t index) const
{
  const Json& view = item("bufferViews", index);
  const std::size_t begin = whole_number(view, "byteOffset", 0);
  const std::size_t size = whole_number(view.at("byteLength"));
  const std::string_view bytes = buffer(whole_number(view.at("buffer")));
  if (begin > bytes.size() || size > bytes.size() - begin)
    fail("is not a whole GLB file: " + m_item + " ends before bufferViews[" +
         std::to_string(index) + ']');
  return bytes.substr(begin, size);
}

Glb_content::Rows Glb_content::rows(const Json& place, const Glb_numbers& numbers,
                                    std::size_t count) const
{
  const std::size_t index = whole_number(place.at("bufferView"));
  const std::string_view bytes = view(index);
  const std::size_t begin = whole_number(place, "byteOffset", 0);
  const std::size_t size = numbers.width * numbers.size;
  const std::size_t stride = whole_number(item("bufferViews", index), "byteStride", size);
  const bool fits = stride > 0 && count <= bytes.size() / stride + 1 && begin <= bytes.size() &&
                    (count == 0 || stride * (count - 1) + size <= bytes.size() - begin);
  if (!fits) fail(m_item + " is too short for " + std::to_string(count) + " rows");
  Rows rows(count, {0, 0, 0, 0});
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < numbers.width; ++k)
      rows[i][k] =
          numbers.read(bytes.data() + begin + stride * i + numbers.size * k, numbers.is_normalized);
  return rows;
}

void Glb_content::replace_rows(Rows& rows, const Json& sparse, const Glb_numbers& numbers) const
{
  const std::size_t count = whole_number(sparse.at("count"));
  const Json& indices = sparse.at("indices");
  const Rows places = this->rows(indices, numbers_of(indices), count);
  const Rows values = this->rows(sparse.at("values"), numbers, count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!(places[i][0] >= 0 && places[i][0] < static_cast<double>(rows.size()))) refuse_item();
    rows[static_cast<std::size_t>(places[i][0])] = values[i];
  }
}

Glb_numbers Glb_content::numbers_of(const Json& table) const
{
  const Glb_numbers* const found = find_numbers(whole_number(table.at("componentType")));
  const std::size_t width = width_of(table.value("type", std::string("SCALAR")));
  if (found == nullptr || width == 0) fail(m_item + " is of an unknown type");
  return {found->size, found->read, width, table.value("normalized", false)};
}

Glb_content::Rows Glb_content::rows(std::size_t accessor) const
{
  const Json& table = item("accessors", accessor);
  const Glb_numbers numbers = numbers_of(table);
  const std::size_t count = whole_number(table.at("count"));
  if (count > m_size)  // only zeros need no bytes
    fail(m_item + " has " + std::to_string(count) +
         " rows, wanted no more than the file has bytes");
  Rows all = table.contains("bufferView") ? rows(table, numbers, count) : Rows(count, {0, 0, 0, 0});
  if (table.contains("sparse")) replace_rows(all, table["sparse"], numbers);
  return all;
}

}  // namespace conformal
