// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_ply.h"

#include "Ply_body.h"

#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/read_bytes.h"

#include <cmath>
#include <limits>

namespace conformal {
namespace {

class Ply_reader {
 public:
  Ply_reader(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
      : m_path(path), m_bad_faces(bad_faces)
  {
    Ply_header header = parse_ply_header(bytes, path);
    check_elements(header);
    m_file.path = path;
    m_file.format = File_format::ply;
    m_file.comments = std::move(header.comments);
    m_file.object_info = std::move(header.object_info);
    m_elements = parse_ply_body(bytes, path, header, m_file.notes);
    take_points(take_element("vertex"));
    if (has_element("face"))
      take_faces(take_element("face"));
    else
      take_strips(take_element("tristrips"));
    for (Ply_element& element : m_elements) m_file.other_elements.push_back(std::move(element));
    if (m_file.polygons.size() == 0) fail("no faces, wanted a surface");
  }

  Surface_file take() { return std::move(m_file); }

 private:
  [[noreturn]] void fail(const std::string& message, std::size_t line = 0) const
  {
    throw Read_error(m_path, line, message);
  }

  [[noreturn]] void fail_at(const Ply_element& element, std::size_t row,
                            const std::string& message) const
  {
    if (!element.lines.empty()) fail(message, element.lines[row]);
    fail(element.name + ' ' + std::to_string(row) + ": " + message);
  }

  // Reports missing elements before the values are read, even if these are invalid.
  void check_elements(const Ply_header& header) const
  {
    bool has_faces = false, has_vertices = false;
    for (std::size_t e = 0; e < header.elements.size(); ++e) {
      const Element& element = header.elements[e];
      const bool is_vertex = element.name == "vertex";
      const bool is_face = element.name == "face" || element.name == "tristrips";
      if (is_vertex && element.size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        fail(std::to_string(element.size) + " vertices, wanted at most 2147483647",
             header.element_lines[e]);
      has_vertices = has_vertices || (is_vertex && element.size != 0);
      has_faces = has_faces || (is_face && element.size != 0);
    }
    if (!has_vertices) fail("no vertices, wanted a surface");
    if (!has_faces) fail("no faces, wanted a surface");
  }

  bool has_element(const char* name) const
  {
    for (const Ply_element& element : m_elements)
      if (element.name == name) return true;
    return false;
  }

  Ply_element take_element(const char* name)
  {
    for (auto element = m_elements.begin(); element != m_elements.end(); ++element)
      if (element->name == name) {
        Ply_element result = std::move(*element);
        m_elements.erase(element);
        return result;
      }
    fail(std::string("no element ") + name + ", wanted a surface");
  }

  void take_points(Ply_element vertices)
  {
    m_file.points.resize(vertices.size);
    const std::array<const char*, 3> names = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
      const Property* property = find_numbers(vertices, names[i]);
      if (property == nullptr)
        fail(std::string("the vertices have no number ") + names[i] + ", wanted x, y and z");
      for (std::size_t v = 0; v < vertices.size; ++v) {
        m_file.points[v][i] = property->value(v);
        if (!std::isfinite(property->value(v)))
          fail_at(vertices, v, std::string("the coordinate ") + names[i] + " is not finite");
      }
      remove_property(vertices, names[i]);
    }
    m_file.vertices = std::move(vertices);
  }

  const Property& index_property(const Ply_element& element) const
  {
    for (const char* name : {"vertex_indices", "vertex_index"}) {
      const Property* property = find_property(element, name);
      if (property == nullptr) continue;
      if (property->is_list() && is_integer(property->type())) return *property;
      fail(std::string("the property ") + name + " is not a list of integers");
    }
    fail("the element " + element.name + " has no list vertex_indices, wanted one");
  }

  void take_faces(Ply_element faces)
  {
    const Property& indices = index_property(faces);
    std::vector<std::int64_t> corners;
    for (std::size_t f = 0; f < faces.size; ++f) {
      corners.clear();
      for (std::size_t i = 0; i < indices.count(f); ++i)
        corners.push_back(indices.integer(indices.first(f) + i));
      const auto* data = corners.data();
      const std::string fault =
          fault_of_face(data, data + corners.size(), m_file.points.size(), 0, m_bad_faces);
      if (!fault.empty()) fail_at(faces, f, fault);
      append_face(m_file.polygons, data, data + corners.size());
    }
    remove_property(faces, std::string(indices.name()));
    m_file.faces = std::move(faces);
  }

  // Triangle i of a strip is (i, i + 1, i + 2), every second one turned over; -1 begins a new
  // strip, and triangles with a repeated corner only serve to go on elsewhere.
  void take_strips(const Ply_element& strips)
  {
    const Property& indices = index_property(strips);
    for (std::size_t row = 0; row < strips.size; ++row) {
      std::size_t begin = indices.first(row);
      const std::size_t end = begin + indices.count(row);
      for (std::size_t i = begin; i < end; ++i) {
        const std::int64_t index = indices.integer(i);
        if (index < -1 || index >= static_cast<std::int64_t>(m_file.points.size()))
          fail_at(strips, row,
                  "a strip has the vertex index " + std::to_string(index) + ", wanted -1 to " +
                      std::to_string(m_file.points.size() - 1));
        if (index == -1)
          begin = i + 1;
        else if (i >= begin + 2)
          append_triangle(indices, i, (i - begin) % 2 == 1);
      }
    }
    m_file.faces.size = m_file.polygons.size();
  }

  void append_triangle(const Property& indices, std::size_t last, bool turn)
  {
    std::array<std::int64_t, 3> corners = {indices.integer(last - 2), indices.integer(last - 1),
                                           indices.integer(last)};
    if (turn) std::swap(corners[0], corners[1]);
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      append_face(m_file.polygons, corners.data(), corners.data() + 3);
  }

  const std::string& m_path;
  Bad_faces m_bad_faces;
  Surface_file m_file;
  std::vector<Ply_element> m_elements;
};

}  // namespace

Surface_file parse_ply(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  return Ply_reader(checked_bytes(bytes, path), path, bad_faces).take();
}

Surface_file read_ply(const std::string& path)
{
  return parse_ply(read_bytes(path), path);
}

}  // namespace conformal
