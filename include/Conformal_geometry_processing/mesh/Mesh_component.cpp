// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Mesh_component.h>

#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

namespace Conformal_geometry_processing {

std::vector<internal::Mesh_component> mesh_components(const Mesh_view& mesh)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<int> component = connected_components(mesh);
  int count = 0;
  for (const int c : component) count = (std::max)(count, c + 1);
  std::vector<internal::Mesh_component> parts(at(count));
  std::vector<Mesh_view::Corners> corners(at(count));
  std::vector<int> number(component.size());  // in its component
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    std::vector<int>& vertices = parts[at(component[at(v)])].vertices;
    number[at(v)] = static_cast<int>(vertices.size());
    vertices.push_back(v);
  }
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const std::array<int, 3>& v = mesh.corners(f);
    const std::size_t c = at(component[at(v[0])]);
    parts[c].faces.push_back(f);
    corners[c].push_back({number[at(v[0])], number[at(v[1])], number[at(v[2])]});
  }
  for (std::size_t c = 0; c < parts.size(); ++c)
    parts[c].mesh =
        Mesh_view(mesh.positions()(Eigen::indexing::all, parts[c].vertices), std::move(corners[c]));
  return parts;
}

internal::Mesh_component internal::selected_faces(const Mesh_view& mesh,
                                                  const std::vector<char>& is_selected)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  Mesh_component part;
  std::vector<int> number(at(mesh.size_of_vertices()), -1);  // in the part
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    if (!is_selected[at(f)]) continue;
    part.faces.push_back(f);
    for (const int v : mesh.corners(f)) number[at(v)] = 0;
  }
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    if (number[at(v)] < 0) continue;
    number[at(v)] = static_cast<int>(part.vertices.size());
    part.vertices.push_back(v);
  }
  Mesh_view::Corners corners;
  for (const int f : part.faces) {
    const std::array<int, 3>& v = mesh.corners(f);
    corners.push_back({number[at(v[0])], number[at(v[1])], number[at(v[2])]});
  }
  part.mesh = Mesh_view(mesh.positions()(Eigen::indexing::all, part.vertices), std::move(corners));
  return part;
}

void internal::Failure_reasons::add(const std::string& name, const std::string& reason)
{
  ++m_size;
  auto group = std::find_if(m_groups.begin(), m_groups.end(),
                            [&](const Group& known) { return known.reason == reason; });
  if (group == m_groups.end()) {
    if (m_groups.size() == max_reasons) return;
    group = m_groups.insert(group, {reason, "", 0});
  }
  if (group->size > 0 && group->size < max_names) group->names += ", ";
  if (group->size++ < max_names) group->names += name;
}

std::string internal::Failure_reasons::text() const
{
  std::string text;
  std::size_t told = 0;
  for (const Group& group : m_groups) {
    if (told > 0) text += "; ";
    told += group.size;
    text += group.names;
    if (group.size > max_names) text += " and " + more(group.size - max_names);
    text += ": " + group.reason;
  }
  if (told < m_size) text += "; " + more(m_size - told) + " for other reasons";
  return text;
}

internal::Component_failures::Component_failures(std::size_t size, std::string function)
    : m_size(size), m_function(std::move(function))
{}

void internal::Component_failures::throw_if_any() const
{
  if (m_reasons.size() == 0) return;
  const std::string all =
      std::to_string(m_reasons.size()) + " of " + std::to_string(m_size) +
      " components failed (their elements are counted in each): " + m_reasons.text();
  if (m_is_of_data) throw Precondition_error(m_function, all);
  throw Solver_error(m_function, all);
}

std::string internal::Component_failures::name_of(std::size_t c, int first_vertex)
{
  return "component " + std::to_string(c) + " (from vertex " + std::to_string(first_vertex) + ")";
}

namespace internal {

/// the 21 low bits of a number, two zeros between each and the next
inline std::uint64_t spread_bits(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffff;
  bits = (bits | bits << 16) & 0x001f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

/// where the cells of the points are along the curve, in a cube that holds all of them
inline std::vector<std::uint64_t> morton_codes(const Points& points)
{
  const double cells = (1 << 21) - 1;
  std::vector<std::uint64_t> codes;
  if (points.cols() == 0) return codes;
  const Eigen::Vector3d low = points.rowwise().minCoeff();
  // Halves, because the difference of large coordinates may be infinite.
  const double extent = (points.rowwise().maxCoeff() / 2 - low / 2).maxCoeff();
  codes.reserve(static_cast<std::size_t>(points.cols()));
  for (const auto point : points.colwise()) {
    std::uint64_t code = 0;
    for (int i = 0; i < 3; ++i) {
      const double share = extent > 0 ? (point[i] / 2 - low[i] / 2) / extent : 0;
      code |= spread_bits(static_cast<std::uint64_t>(cells * share)) << i;
    }
    codes.push_back(code);
  }
  return codes;
}

inline std::vector<int> vertices_along_curve(const Points& points)
{
  const std::vector<std::uint64_t> codes = morton_codes(points);
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(codes.size());
  for (const std::uint64_t code : codes) keys.emplace_back(code, static_cast<int>(keys.size()));
  const auto position = [&](int v) { return std::tuple(points(0, v), points(1, v), points(2, v)); };
  std::sort(keys.begin(), keys.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    const auto p = position(a.second), q = position(b.second);
    return p != q ? p < q : a.second < b.second;
  });
  std::vector<int> vertices;
  vertices.reserve(keys.size());
  for (const auto& key : keys) vertices.push_back(key.second);
  return vertices;
}

/// of each vertex where those at its position begin in the order
inline std::vector<int> places(const Mesh_view& mesh, const std::vector<int>& order)
{
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || mesh.position(order[k]) != mesh.position(order[k - 1]);
    place[static_cast<std::size_t>(order[k])] =
        is_new ? static_cast<int>(k) : place[static_cast<std::size_t>(order[k - 1])];
  }
  return place;
}

/// orders vertices at one position by the places of their neighbours
inline void order_coinciding(const Mesh_view& mesh, std::vector<int>& order)
{
  const std::vector<int> place = places(mesh, order);
  const auto at = [&](int v) {
    return static_cast<std::size_t>(place[static_cast<std::size_t>(v)]);
  };
  std::vector<int> count(order.size(), 0);
  for (const int v : order) ++count[at(v)];
  if (std::count(count.begin(), count.end(), 1) == mesh.size_of_vertices()) return;
  std::vector<std::vector<int>> neighbours(order.size());
  const auto add = [&](int v, int w) {
    if (count[at(v)] > 1)
      neighbours[static_cast<std::size_t>(v)].push_back(static_cast<int>(at(w)));
  };
  for (const auto& [a, b] : mesh.ends()) add(a, b), add(b, a);
  for (std::vector<int>& own : neighbours) std::sort(own.begin(), own.end());
  std::stable_sort(order.begin(), order.end(), [&](int v, int w) {
    return at(v) != at(w)
               ? at(v) < at(w)
               : neighbours[static_cast<std::size_t>(v)] < neighbours[static_cast<std::size_t>(w)];
  });
}

/// the faces of the mesh with the numbers of their vertices, sorted, and where they were
inline std::vector<std::pair<std::array<int, 3>, int>> sorted_faces(const Mesh_view& mesh,
                                                                    const std::vector<int>& number)
{
  const auto at = [&](int v) { return number[static_cast<std::size_t>(v)]; };
  std::vector<std::pair<std::array<int, 3>, int>> faces;
  faces.reserve(mesh.corners().size());
  for (const auto& [a, b, c] : mesh.corners()) {
    std::array<int, 3> corners{at(a), at(b), at(c)};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.emplace_back(corners, static_cast<int>(faces.size()));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

Mesh_component in_morton_order(const Mesh_component& part)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> order = vertices_along_curve(part.mesh.positions());
  order_coinciding(part.mesh, order);
  Mesh_component ordered;
  std::vector<int> number(order.size());
  for (const int v : order) {
    number[at(v)] = static_cast<int>(ordered.vertices.size());
    ordered.vertices.push_back(part.vertices[at(v)]);
  }
  Mesh_view::Corners corners;
  for (const auto& [own, f] : sorted_faces(part.mesh, number)) {
    corners.push_back(own);
    ordered.faces.push_back(part.faces[at(f)]);
  }
  ordered.mesh = Mesh_view(part.mesh.positions()(Eigen::indexing::all, order), std::move(corners));
  return ordered;
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
