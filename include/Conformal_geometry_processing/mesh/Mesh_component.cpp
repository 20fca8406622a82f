// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Mesh_component.h>

#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <array>
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

}  // namespace Conformal_geometry_processing
