// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_glb.h"

#include "Glb_content.h"
#include "attribute_names.h"

#include "conformal/io/data/Left_out.h"
#include "conformal/io/data/Vertex_merger.h"
#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/numbers.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace conformal {
namespace {

using Json = nlohmann::json;
using Rows = Glb_content::Rows;

Eigen::Affine3d placement(const Json& node)
{
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  if (node.contains("matrix")) {
    const auto m = node["matrix"].get<std::array<double, 16>>();
    place.matrix() = Eigen::Matrix4d::Map(m.data());
    return place;
  }
  const auto t = node.value("translation", std::array<double, 3>{0, 0, 0});
  const auto q = node.value("rotation", std::array<double, 4>{0, 0, 0, 1});
  const auto s = node.value("scale", std::array<double, 3>{1, 1, 1});
  place.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  place.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]));
  place.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  return place;
}

enum Mode : std::size_t { triangle_list = 4, triangle_strip = 5, triangle_fan = 6 };

using Triangle = std::array<std::size_t, 3>;

// Number t of the triangles of a primitive, counter-clockwise, as places among its indices
Triangle triangle_of(std::size_t mode, std::size_t t)
{
  if (mode == triangle_strip) return {t, t + 1 + t % 2, t + 2 - t % 2};
  if (mode == triangle_fan) return {0, t + 1, t + 2};
  return {3 * t, 3 * t + 1, 3 * t + 2};
}

std::size_t triangles_of(std::size_t mode, std::size_t indices)
{
  return mode == triangle_list ? indices / 3 : std::max<std::size_t>(indices, 2) - 2;
}

// In strips, triangles with a repeated corner only serve to go on elsewhere.
bool is_stitch(const std::vector<std::size_t>& corners, const Triangle& t)
{
  return corners[t[0]] == corners[t[1]] || corners[t[1]] == corners[t[2]] ||
         corners[t[2]] == corners[t[0]];
}

/// A value for each vertex; of the copies of a vertex the first one with a value counts.
struct Vertex_table {
  std::string name;
  std::vector<std::optional<std::array<double, 4>>> rows;

  void add(const std::vector<std::int64_t>& vertices, const Rows& values)
  {
    for (std::size_t i = 0; i < std::min(vertices.size(), values.size()); ++i) {
      const auto v = static_cast<std::size_t>(vertices[i]);
      if (rows.size() <= v) rows.resize(v + 1);
      if (!rows[v]) rows[v] = values[i];
    }
  }
};

class Glb_reader {
 public:
  Glb_reader(const Glb_content& content, const std::string& path, Bad_faces bad_faces)
      : m_content(content), m_bad_faces(bad_faces), m_merger(m_file.points)
  {
    m_file.path = path;
    m_file.format = File_format::glb;
    const Json& json = m_content.json();
    m_is_own = json.value("asset", Json::object()).value("generator", "") == "conformal";
    if (json.contains("scenes"))
      read_nodes();
    else
      for (std::size_t i = 0; i < size_of("meshes"); ++i) read_mesh(i, Eigen::Affine3d::Identity());
    if (m_file.polygons.size() == 0) throw Read_error(path, 0, "no triangles, wanted a surface");
    leave_out_unread();
    finish();
  }

  Surface_file take() { return std::move(m_file); }

 private:
  std::size_t size_of(const char* list) const
  {
    const auto found = m_content.json().find(list);
    return found == m_content.json().end() ? 0 : found->size();
  }

  // Nodes form trees; where they do not, the number of ways through them may be exponential.
  void read_nodes()
  {
    std::vector<std::pair<std::size_t, Eigen::Affine3d>> left;  // the next one is the last
    const auto append = [&left](const Json& parent, const char* list,
                                const Eigen::Affine3d& place) {
      const Json nodes = parent.value(list, Json::array());
      for (std::size_t i = nodes.size(); i > 0; --i)
        left.emplace_back(whole_number(nodes.at(i - 1)), place);
    };
    const std::size_t scene = whole_number(m_content.json(), "scene", 0);
    append(m_content.item("scenes", scene), "nodes", Eigen::Affine3d::Identity());
    while (!left.empty()) {
      const auto [index, parent] = left.back();
      left.pop_back();
      if (!m_read_nodes.insert(index).second)
        throw Read_error(
            m_file.path, 0,
            "nodes[" + std::to_string(index) + "] is below itself, or below two others");
      const Json& node = m_content.item("nodes", index);
      m_where = "nodes[" + std::to_string(index) + ']';
      const Eigen::Affine3d place = parent * placement(node);
      append(node, "children", place);
      read_node(node, place);
    }
  }

  void read_node(const Json& node, const Eigen::Affine3d& place)
  {
    leave_out_others(node,
                     {"name", "children", "matrix", "translation", "rotation", "scale", "mesh"});
    if (!node.contains("mesh")) return;
    begin_group("g", node);
    read_mesh(whole_number(node["mesh"]), place);
  }

  void read_mesh(std::size_t index, const Eigen::Affine3d& place)
  {
    const Json& mesh = m_content.item("meshes", index);
    m_read_meshes.insert(index);
    m_where = "meshes[" + std::to_string(index) + ']';
    leave_out_others(mesh, {"name", "primitives"});
    begin_group("o", mesh);
    for (const Json& primitive : mesh.at("primitives")) read_primitive(primitive, place);
  }
  void begin_group(const std::string& keyword, const Json& named)
  {
    const std::string name = named.value("name", std::string());
    if (!name.empty()) m_file.group_lines.push_back({m_file.polygons.size(), keyword + ' ' + name});
  }

  // The checkerboard of our own files is not a loss.
  void begin_material(std::size_t index)
  {
    const Json& material = m_content.item("materials", index);
    begin_group("usemtl", material);
    if (!m_is_own && material.size() > material.count("name"))
      m_left_out.add("colours and pictures of materials",
                     "materials[" + std::to_string(index) + ']');
  }

  // Extensions are in a list of their own.
  void leave_out_others(const Json& object, const std::vector<std::string_view>& known)
  {
    for (const auto& [key, value] : object.items())
      if (key != "extensions" && std::find(known.begin(), known.end(), key) == known.end())
        m_left_out.add(key, m_where);
  }

  void leave_out_unread()
  {
    m_where.clear();
    const Json& json = m_content.json();
    leave_out_others(json, {"asset", "scene", "scenes", "nodes", "meshes", "materials", "textures",
                            "images", "samplers", "skins", "cameras", "buffers", "bufferViews",
                            "accessors", "extensionsUsed", "extensionsRequired"});
    for (const Json& extension : json.value("extensionsUsed", Json::array()))
      if (extension != "KHR_mesh_quantization")
        m_left_out.add("the extension " + extension.get<std::string>(), m_where);
    for (std::size_t i = 0; i < size_of("scenes"); ++i)
      if (i != whole_number(json, "scene", 0))
        m_left_out.add("further scenes", "scenes[" + std::to_string(i) + ']');
    for (std::size_t i = 0; i < size_of("meshes"); ++i)
      if (m_read_meshes.count(i) == 0)
        m_left_out.add("meshes outside of the scene", "meshes[" + std::to_string(i) + ']');
  }

  void read_primitive(const Json& primitive, const Eigen::Affine3d& place)
  {
    const std::size_t mode = whole_number(primitive, "mode", triangle_list);
    if (mode < triangle_list || mode > triangle_fan) {
      m_left_out.add("points and lines", m_where);
      return;
    }
    leave_out_others(primitive, {"attributes", "indices", "material", "mode"});
    if (primitive.contains("material")) begin_material(whole_number(primitive["material"]));
    const Json& attributes = primitive.at("attributes");
    const Rows points = rows(attributes, "POSITION");
    const std::vector<std::int64_t> vertices = vertices_at(points, place);
    read_attributes(attributes, vertices);
    const int first_row = append_texture(rows(attributes, "TEXCOORD_0"), points.size());
    const std::vector<std::size_t> corners = indices(primitive, points.size());
    for (std::size_t t = 0; t < triangles_of(mode, corners.size()); ++t) {
      Triangle at = triangle_of(mode, t);
      if (mode != triangle_list && is_stitch(corners, at)) continue;
      if (place.linear().determinant() < 0) std::swap(at[1], at[2]);  // as seen in a mirror
      add_face({corners[at[0]], corners[at[1]], corners[at[2]]}, vertices, first_row);
    }
    if (mode == triangle_list && corners.size() % 3 != 0)
      m_left_out.add("corners after the last triangle", m_where);
  }

  // none if there is no such attribute
  Rows rows(const Json& attributes, const char* name) const
  {
    return attributes.contains(name) ? m_content.rows(whole_number(attributes[name])) : Rows();
  }

  // In the order of their tables, since that of JSON is none.
  void read_attributes(const Json& attributes, const std::vector<std::int64_t>& vertices)
  {
    std::vector<std::pair<std::size_t, std::string>> all;
    for (const auto& [name, accessor] : attributes.items())
      if (name != "POSITION" && name != "NORMAL" && name != "TEXCOORD_0")
        all.emplace_back(whole_number(accessor), name);
    std::sort(all.begin(), all.end());
    for (const auto& [accessor, name] : all)
      if (name == "COLOR_0")
        m_colors.add(vertices, colors(accessor));
      else if (const auto property = property_of(name); property && has_type(accessor, "SCALAR"))
        values_of(*property).add(vertices, m_content.rows(accessor));
      else
        m_left_out.add(name, m_where);
  }

  bool has_type(std::size_t accessor, const char* type) const
  {
    return m_content.item("accessors", accessor).value("type", "") == type;
  }

  Rows colors(std::size_t accessor) const
  {
    Rows rows = m_content.rows(accessor);
    if (has_type(accessor, "VEC3"))
      for (auto& row : rows) row[3] = 1;
    return rows;
  }

  Vertex_table& values_of(const std::string& property)
  {
    const auto is_same = [&](const Vertex_table& table) { return table.name == property; };
    const auto known = std::find_if(m_values.begin(), m_values.end(), is_same);
    return known != m_values.end() ? *known : m_values.emplace_back(Vertex_table{property, {}});
  }

  // One row for each point, or none. \returns the number of the first one, or -1
  int append_texture(const Rows& rows, std::size_t points)
  {
    auto& texture = m_file.texture.values;
    const auto first = static_cast<int>(texture.size());
    if (rows.size() < points || rows.empty()) {
      if (!rows.empty()) m_left_out.add("TEXCOORD_0", m_where);
      return -1;
    }
    for (const auto& row : rows) texture.push_back({row[0], 1 - row[1], 0});
    return first;
  }

  [[noreturn]] void refuse_index(double index, std::size_t size) const
  {
    std::string message = "a face has the vertex index ";
    append_number(message, index);
    throw Read_error(m_file.path, 0,
                     message + ", wanted 0 or more, and less than " + std::to_string(size));
  }

  std::vector<std::size_t> indices(const Json& primitive, std::size_t size) const
  {
    std::vector<std::size_t> all;
    if (primitive.contains("indices")) {
      for (const auto& row : m_content.rows(whole_number(primitive["indices"]))) {
        if (!(row[0] >= 0 && row[0] < static_cast<double>(size))) refuse_index(row[0], size);
        all.push_back(static_cast<std::size_t>(row[0]));
      }
    } else {
      for (std::size_t i = 0; i < size; ++i) all.push_back(i);
    }
    return all;
  }

  std::vector<std::int64_t> vertices_at(const Rows& points, const Eigen::Affine3d& place)
  {
    std::vector<std::int64_t> vertices;
    for (const auto& row : points) {
      const Eigen::Vector3d p = place * Eigen::Vector3d(row[0], row[1], row[2]);
      if (!p.allFinite()) throw Read_error(m_file.path, 0, "a coordinate is not a finite number");
      vertices.push_back(m_merger.vertex({p.x(), p.y(), p.z()}));
    }
    return vertices;
  }

  void add_face(const Triangle& points, const std::vector<std::int64_t>& vertices, int first_row)
  {
    std::array<std::int64_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = vertices[points[k]];
    const std::string fault =
        fault_of_face(corners.data(), corners.data() + 3, m_file.points.size(), 0, m_bad_faces);
    if (!fault.empty())
      throw Read_error(m_file.path, 0,
                       "face " + std::to_string(m_file.polygons.size()) + ": " + fault);
    append_face(m_file.polygons, corners.data(), corners.data() + 3);
    for (const std::size_t i : points)
      m_file.texture.index.push_back(first_row < 0 ? -1 : first_row + static_cast<int>(i));
  }

  void finish()
  {
    m_file.vertices.size = m_file.points.size();
    m_file.faces.size = m_file.polygons.size();
    if (m_file.texture.values.empty()) m_file.texture.index.clear();
    if (!m_colors.rows.empty()) set_colors();
    for (Vertex_table& table : m_values) set_values(table);
    m_file.notes = m_left_out.notes();
  }

  void set_values(Vertex_table& table)
  {
    table.rows.resize(m_file.points.size());
    std::vector<float> values;
    for (const auto& row : table.rows) {
      if (!row) {
        m_left_out.add(table.name + ", which not all vertices have",
                       "vertex " + std::to_string(values.size()));
        return;
      }
      values.push_back(static_cast<float>((*row)[0]));
    }
    set_property(m_file.vertices, table.name, values);
  }

  void set_colors()
  {
    m_colors.rows.resize(m_file.points.size());
    bool has_alpha = false;
    std::vector<double> bytes;
    for (const auto& row : m_colors.rows)
      for (std::size_t k = 0; k < 4; ++k) {
        bytes.push_back(std::round(255 * (row ? std::clamp((*row)[k], 0., 1.) : 1)));
        has_alpha = has_alpha || (k == 3 && bytes.back() < 255);
      }
    set_properties(m_file.vertices, {"red", "green", "blue", "alpha"}, Value_type::uint8, bytes);
    if (!has_alpha) remove_property(m_file.vertices, "alpha");
  }

  Surface_file m_file;
  const Glb_content& m_content;
  Bad_faces m_bad_faces;
  Vertex_merger m_merger;
  Left_out m_left_out;
  std::string m_where;  // what is read, for notes
  std::set<std::size_t> m_read_nodes, m_read_meshes;
  Vertex_table m_colors;
  std::vector<Vertex_table> m_values;
  bool m_is_own = false;  // written by this program
};

}  // namespace

Surface_file parse_glb(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  const Glb_content content(bytes, path);
  try {
    return Glb_reader(content, path, bad_faces).take();
  } catch (const Json::exception&) {
    content.refuse_item();
  }
}

}  // namespace conformal
