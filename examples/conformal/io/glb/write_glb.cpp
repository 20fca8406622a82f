// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_glb.h"

#include "Glb_mesh.h"
#include "checkerboard.h"

#include "conformal/io/data/note_losses.h"
#include "conformal/io/file/base64.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/little_endian.h"
#include "conformal/io/file/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace conformal {
namespace {

enum Component { unsigned_byte = 5121, unsigned_int = 5125, float_number = 5126 };
enum Target { no_target = 0, vertex_data = 34962, index_data = 34963 };

template <class Number, std::size_t N>
std::string numbers_text(const std::array<Number, N>& numbers)
{
  std::string text;
  for (const Number number : numbers) {
    text += text.empty() ? '[' : ',';
    append_number(text, static_cast<double>(number));  // a float as its exact double
  }
  return text + ']';
}

// The binary chunk and, for the JSON chunk, the positions of its contents.
class Glb_buffer {
 public:
  // a view of the bytes appended since `begin`; returns its number
  std::size_t end_view(std::size_t begin, Target target)
  {
    std::string view = "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
                       ",\"byteLength\":" + std::to_string(m_bytes.size() - begin);
    if (target != no_target) view += ",\"target\":" + std::to_string(target);
    append(m_views, view + '}');
    m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0');  // every view begins at a multiple of 4
    return m_view_count++;
  }

  // an array of numbers; `properties` are more of the accessor's
  template <class Number, std::size_t N>
  std::size_t append_array(const std::vector<std::array<Number, N>>& rows, Target target,
                           Component component, const char* type, std::size_t count,
                           const std::string& properties = "")
  {
    const std::size_t begin = m_bytes.size();
    for (const auto& row : rows)
      for (const Number number : row) append_little_endian(m_bytes, number);
    const std::size_t view = end_view(begin, target);
    append(m_accessors, "{\"bufferView\":" + std::to_string(view) +
                            ",\"componentType\":" + std::to_string(component) + ",\"type\":\"" +
                            type + "\",\"count\":" + std::to_string(count) + properties + '}');
    return m_accessor_count++;
  }

  std::size_t append_bytes(const std::string& bytes)
  {
    const std::size_t begin = m_bytes.size();
    m_bytes += bytes;
    return end_view(begin, no_target);
  }

  const std::string& bytes() const { return m_bytes; }

  /// \param is_inside whether the bytes are in the description
  std::string json(bool is_inside) const
  {
    const std::string uri =
        is_inside ? ",\"uri\":\"data:application/octet-stream;base64," + base64(m_bytes) + '"' : "";
    return "\"buffers\":[{\"byteLength\":" + std::to_string(m_bytes.size()) + uri +
           "}],\"bufferViews\":[" + m_views + "],\"accessors\":[" + m_accessors + ']';
  }

 private:
  static void append(std::string& list, const std::string& item)
  {
    list += (list.empty() ? "" : ",") + item;
  }

  std::string m_bytes, m_views, m_accessors;
  std::size_t m_view_count = 0, m_accessor_count = 0;
};

std::string bounds(const std::vector<std::array<float, 3>>& positions)
{
  std::array<float, 3> low = positions.front(), high = low;
  for (const auto& position : positions)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], position[i]);
      high[i] = std::max(high[i], position[i]);
    }
  return ",\"min\":" + numbers_text(low) + ",\"max\":" + numbers_text(high);
}

std::string append_attributes(Glb_buffer& buffer, const Glb_mesh& mesh)
{
  const std::size_t n = mesh.positions.size();
  const auto attribute = [](const std::string& name, std::size_t accessor) {
    return '"' + name + "\":" + std::to_string(accessor);
  };
  std::string text =
      attribute("POSITION", buffer.append_array(mesh.positions, vertex_data, float_number, "VEC3",
                                                n, bounds(mesh.positions)));
  text += ',' + attribute("NORMAL",
                          buffer.append_array(mesh.normals, vertex_data, float_number, "VEC3", n));
  if (!mesh.texture.empty())
    text += ',' + attribute("TEXCOORD_0", buffer.append_array(mesh.texture, vertex_data,
                                                              float_number, "VEC2", n));
  if (!mesh.colors.empty())
    text += ',' + attribute("COLOR_0", buffer.append_array(mesh.colors, vertex_data, unsigned_byte,
                                                           "VEC4", n, ",\"normalized\":true"));
  for (const auto& [property, name, rows] : mesh.values)
    text +=
        ',' + attribute(name, buffer.append_array(rows, vertex_data, float_number, "SCALAR", n));
  return text;
}

// A dull surface that is seen from both sides, for most surfaces with boundary are.
std::string material(Glb_buffer& buffer, const Glb_mesh& mesh)
{
  const bool has_checkerboard = !mesh.texture.empty() && mesh.colors.empty();
  std::string text =
      "\"materials\":[{\"doubleSided\":true,\"pbrMetallicRoughness\":{"
      "\"metallicFactor\":0,\"roughnessFactor\":0.8";
  if (has_checkerboard) text += ",\"baseColorTexture\":{\"index\":0}";
  text += "}}],";
  if (!has_checkerboard) return text;
  const std::size_t view = buffer.append_bytes(checkerboard_png(16, 16));
  return text +
         "\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{}],\"images\":[{"
         "\"mimeType\":\"image/png\",\"bufferView\":" +
         std::to_string(view) + "}],";
}

std::string json_text(Glb_buffer& buffer, const Glb_mesh& mesh, bool is_inside)
{
  const std::string attributes = append_attributes(buffer, mesh);
  const std::size_t indices = buffer.append_array(mesh.triangles, index_data, unsigned_int,
                                                  "SCALAR", 3 * mesh.triangles.size());
  const std::string materials = material(buffer, mesh);
  return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"conformal\"},\"scene\":0,"
         "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"translation\":" +
         numbers_text(mesh.middle) + "}],\"meshes\":[{\"primitives\":[{\"attributes\":{" +
         attributes + "},\"indices\":" + std::to_string(indices) + ",\"material\":0}]}]," +
         materials + buffer.json(is_inside) + '}';
}

void append_chunk(std::string& glb, const char* type, const std::string& bytes)
{
  append_little_endian(glb, static_cast<std::uint32_t>(bytes.size()));
  glb.append(type, 4);
  glb += bytes;
}

void check_positions(const Glb_mesh& mesh, const std::string& path)
{
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    for (const float x : mesh.positions[v])
      if (!std::isfinite(x))
        throw Write_error(path, "vertex " + std::to_string(v) +
                                    " does not fit into GLB, whose coordinates are floats");
}

Written written_to_glb(const Surface_file& file, const Glb_mesh& mesh)
{
  Written all{"GLB"};
  all.vertices = names_of(normal_properties(file.vertices));
  for (const std::string& name : names_of(color_properties(file.vertices)))
    all.vertices.push_back(name);
  for (const Glb_mesh::Values& values : mesh.values) all.vertices.push_back(values.property);
  all.texture = Detail::corners;
  all.normals = Detail::vertices;
  all.has_polygons = false;
  return all;
}

}  // namespace

std::string encode_glb(const Surface_file& file, const std::string& path,
                       std::vector<std::string>& notes)
{
  const Glb_mesh mesh = glb_mesh(file);
  check_positions(mesh, path);
  Glb_buffer buffer;
  std::string json = json_text(buffer, mesh, false);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t size = 28 + json.size() + buffer.bytes().size();
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw Write_error(path, std::to_string(size) + " bytes are too many for GLB, at most 4 GiB");
  std::string glb = "glTF";
  append_little_endian(glb, std::uint32_t{2});
  append_little_endian(glb, static_cast<std::uint32_t>(size));
  append_chunk(glb, "JSON", json);
  append_chunk(glb, "BIN\0", buffer.bytes());
  note_losses(file, written_to_glb(file, mesh), notes);
  return glb;
}

std::string encode_gltf(const Surface_file& file, const std::string& path,
                        std::vector<std::string>& notes)
{
  const Glb_mesh mesh = glb_mesh(file);
  check_positions(mesh, path);
  Glb_buffer buffer;
  note_losses(file, written_to_glb(file, mesh), notes);
  return json_text(buffer, mesh, true);
}

}  // namespace conformal
