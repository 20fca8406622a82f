// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_glb.h"

#include "Glb_content.h"

#include "conformal/io/data/Vertex_merger.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/numbers.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

namespace conformal {
namespace {

using Json = nlohmann::json;
using Rows = std::vector<std::array<double, 4>>;

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

class Glb_reader {
 public:
  Glb_reader(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
      : m_content(bytes, path), m_bad_faces(bad_faces), m_merger(m_file.points)
  {
    m_file.path = path;
    m_file.format = File_format::glb;
    const Json& json = m_content.json();
    if (json.contains("scenes") && !json["scenes"].empty()) {
      for (const Json& node :
           json["scenes"].at(json.value("scene", std::size_t{0})).value("nodes", Json::array()))
        read_node(node.get<std::size_t>(), Eigen::Affine3d::Identity());
    } else if (json.contains("meshes")) {
      for (const Json& mesh : json["meshes"]) read_mesh(mesh, Eigen::Affine3d::Identity());
    }
    if (m_file.polygons.size() == 0) throw Read_error(path, 0, "no triangles, wanted a surface");
    finish();
  }

  Surface_file take() { return std::move(m_file); }

 private:
  // Nodes form trees; where they do not, the number of ways through them may be exponential.
  void read_node(std::size_t index, const Eigen::Affine3d& parent)
  {
    const Json& json = m_content.json();
    if (!m_read_nodes.insert(index).second)
      throw Read_error(m_file.path, 0, "a node is below itself, or below two others");
    const Json& node = json.at("nodes").at(index);
    const Eigen::Affine3d place = parent * placement(node);
    if (node.contains("mesh"))
      read_mesh(json.at("meshes").at(node["mesh"].get<std::size_t>()), place);
    for (const Json& child : node.value("children", Json::array()))
      read_node(child.get<std::size_t>(), place);
  }

  void read_mesh(const Json& mesh, const Eigen::Affine3d& place)
  {
    begin_group("o", mesh);
    const int triangles = 4;
    for (const Json& primitive : mesh.at("primitives"))
      if (primitive.value("mode", triangles) == triangles)
        read_triangles(primitive, place);
      else
        m_has_others = true;
  }

  void begin_group(const std::string& keyword, const Json& named)
  {
    const std::string name = named.value("name", std::string());
    if (!name.empty()) m_file.group_lines.push_back({m_file.polygons.size(), keyword + ' ' + name});
  }

  void begin_material(const Json& material)
  {
    begin_group("usemtl", material);
    m_has_looks = m_has_looks || material.size() > material.count("name");
  }

  // The checkerboard of our own files is no loss.
  bool loses_looks() const
  {
    const Json& asset = m_content.json().value("asset", Json::object());
    return m_has_looks && asset.value("generator", std::string()) != "conformal";
  }

  std::optional<Rows> rows(const Json& attributes, const char* name) const
  {
    if (!attributes.contains(name)) return {};
    return m_content.rows(attributes[name].get<std::size_t>());
  }

  void read_triangles(const Json& primitive, const Eigen::Affine3d& place)
  {
    if (primitive.contains("material"))
      begin_material(m_content.json().at("materials").at(primitive["material"].get<std::size_t>()));
    const Json& attributes = primitive.at("attributes");
    const Rows points = rows(attributes, "POSITION").value_or(Rows());
    const std::optional<Rows> texture = rows(attributes, "TEXCOORD_0");
    const std::vector<std::int64_t> vertices = vertices_at(points, place);
    add_colors(vertices, rows(attributes, "COLOR_0"));
    const int first_row = static_cast<int>(m_file.texture.values.size());
    if (texture)
      for (const auto& row : *texture) m_file.texture.values.push_back({row[0], 1 - row[1], 0});
    for (const std::size_t i : indices(primitive, points.size())) {
      m_corners.push_back(vertices.at(i));
      m_file.texture.index.push_back(
          texture && i < texture->size() ? first_row + static_cast<int>(i) : -1);
      if (m_corners.size() == 3) add_face();
    }
    m_corners.clear();
    m_file.texture.index.resize(m_file.polygons.corners.size());
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
      for (const auto& row : m_content.rows(primitive["indices"].get<std::size_t>())) {
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

  // Of the copies of a vertex the first one with a colour counts.
  void add_colors(const std::vector<std::int64_t>& vertices, const std::optional<Rows>& colors)
  {
    m_colors.resize(m_file.points.size());
    if (!colors) return;
    for (std::size_t i = 0; i < std::min(vertices.size(), colors->size()); ++i) {
      auto& color = m_colors[static_cast<std::size_t>(vertices[i])];
      if (!color) color = (*colors)[i];
      m_has_colors = true;
    }
  }

  void add_face()
  {
    const std::string fault =
        fault_of_face(m_corners.data(), m_corners.data() + 3, m_file.points.size(), 0, m_bad_faces);
    if (!fault.empty())
      throw Read_error(m_file.path, 0,
                       "face " + std::to_string(m_file.polygons.size()) + ": " + fault);
    append_face(m_file.polygons, m_corners.data(), m_corners.data() + 3);
    m_corners.clear();
  }

  void finish()
  {
    m_file.vertices.size = m_file.points.size();
    m_file.faces.size = m_file.polygons.size();
    if (m_file.texture.values.empty()) m_file.texture.index.clear();
    if (m_has_others) m_file.notes.emplace_back("what is not made of triangles is left out");
    if (loses_looks())
      m_file.notes.emplace_back(
          "of materials the names are kept, colours and pictures are left out");
    if (!m_has_colors) return;
    std::vector<double> bytes;
    for (const auto& color : m_colors)
      for (std::size_t k = 0; k < 3; ++k)
        bytes.push_back(std::round(255 * (color ? (*color)[k] : 1)));
    set_properties(m_file.vertices, {"red", "green", "blue"}, Value_type::uint8, bytes);
  }

  Surface_file m_file;
  Glb_content m_content;
  Bad_faces m_bad_faces;
  Vertex_merger m_merger;
  std::set<std::size_t> m_read_nodes;
  std::vector<std::int64_t> m_corners;  // of the face that is read
  std::vector<std::optional<std::array<double, 4>>> m_colors;
  bool m_has_colors = false, m_has_others = false, m_has_looks = false;
};

}  // namespace

Surface_file parse_glb(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  try {
    return Glb_reader(bytes, path, bad_faces).take();
  } catch (const nlohmann::json::exception& error) {
    throw Read_error(path, 0, std::string("is not a GLB file: ") + error.what());
  } catch (const std::out_of_range&) {
    throw Read_error(path, 0, "is not a GLB file: an accessor is of an unknown type");
  }
}

}  // namespace conformal
