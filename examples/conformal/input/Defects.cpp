// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Defects.h"

#include "conformal/process/Failure.h"
#include "conformal/process/text.h"

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>

namespace conformal {
namespace {

// The library's own judgement on a rule.
template <class Requirement>
bool holds(const Requirement& requirement, const CGP::Mesh_view& mesh)
{
  try {
    requirement(mesh, "");
  } catch (const CGP::Precondition_error&) {
    return false;
  }
  return true;
}

// `3 faces of area zero (first: face 7); try: ...`, or nothing if no element is bad
template <class Is_bad, class Name>
void add_if_any(std::vector<std::string>& defects, int size, const Is_bad& is_bad, const Name& name,
                const std::string& noun, const std::string& what, const std::string& advice)
{
  int first = -1;
  std::size_t count = 0;
  for (int i = 0; i < size; ++i)
    if (is_bad(i) && count++ == 0) first = i;
  if (count > 0)
    defects.push_back(count_of(count, noun) + what + " (first: " + name(first) +
                      "); try: " + advice);
}

/// the mesh without all its faces but those at one vertex: whether they form one fan
std::vector<char> split_vertices(const CGP::Mesh_view& mesh)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> corners(at(mesh.size_of_vertices()), 0), start(corners.size(), -1);
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const int v = mesh.from(h);
    ++corners[at(v)];
    if (start[at(v)] < 0 || mesh.twin(h) < 0) start[at(v)] = h;
  }
  std::vector<char> is_split(corners.size(), 0);
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    int met = 0;
    for (int h = start[at(v)]; h >= 0 && met <= corners[at(v)];) {
      ++met;
      h = mesh.twin(CGP::Mesh_view::previous_in_face(h));
      if (h == start[at(v)]) break;
    }
    is_split[at(v)] = met != corners[at(v)];
  }
  return is_split;
}

void find_topological(const Surface_input& input, std::vector<std::string>& defects)
{
  const CGP::Mesh_view& mesh = input.mesh;
  add_if_any(
      defects, mesh.size_of_edges(),
      [&](int k) { return mesh.halfedges_end(k) - mesh.halfedges_begin(k) > 2; },
      [&](int k) { return name_of_edge(input, k); }, "non-manifold edge",
      " where more than two faces meet", "cut the surface there, as --repair does");
  if (!defects.empty()) return;
  if (!input.is_orientable) {
    defects.emplace_back(
        "the surface is not orientable (one-sided, like a Moebius strip); try: cut it open, as "
        "--repair does");
    return;
  }
  if (holds(CGP::require_manifold_vertices, mesh)) return;
  const std::vector<char> is_split = split_vertices(mesh);
  add_if_any(
      defects, mesh.size_of_vertices(),
      [&](int v) { return is_split[static_cast<std::size_t>(v)] != 0; },
      [&](int v) { return name_of_vertex(input, v); }, "non-manifold vertex",
      " where several fans of faces touch", "cut the surface there, as --repair does");
}

bool is_flat(const CGP::Mesh_view& mesh, int f)
{
  const auto& v = mesh.corners(f);
  CGP::Points p(3, 3);
  p << mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]);
  return !holds(CGP::require_positive_areas, CGP::Mesh_view(std::move(p), {{0, 1, 2}}));
}

void find_geometrical(const Surface_input& input, Defects& found)
{
  const CGP::Mesh_view& mesh = input.mesh;
  std::vector<std::string>& defects = found.of_geometry;
  const double largest = 1e300;
  add_if_any(
      defects, mesh.size_of_vertices(),
      [&](int v) { return !(mesh.position(v).cwiseAbs().maxCoeff() <= largest); },
      [&](int v) { return name_of_vertex(input, v); }, "vertex", " beyond the coordinate 1e300",
      "scale the mesh down");
  found.has_area = defects.empty() && holds(CGP::require_some_area, mesh);
  if (!defects.empty() || holds(CGP::require_positive_areas, mesh)) return;
  if (!found.has_area) {
    defects.push_back("no face has an area, wanted a surface; try: another mesh");
    return;
  }
  add_if_any(
      defects, mesh.size_of_faces(), [&](int f) { return is_flat(mesh, f); },
      [&](int f) { return name_of_face(input, f); }, "face", " of area zero",
      std::string(input.repair ? "" : "--repair, which mends most of them, or ") +
          "--mollify of spin, flow and fit, which takes them as they are");
}

}  // namespace

std::string Defects::first(Flat_faces flat_faces) const
{
  for (const auto* kind : {&of_topology, &of_components})
    if (!kind->empty()) return kind->front();
  const bool is_fine = of_geometry.empty() || (flat_faces == Flat_faces::allowed && has_area);
  return is_fine ? std::string() : of_geometry.front();
}

Defects find_defects(const Surface_input& input)
{
  Defects defects;
  find_topological(input, defects.of_topology);
  int components = 0, second = -1;
  const std::vector<int> component = CGP::connected_components(input.mesh);
  for (std::size_t v = 0; v < component.size(); ++v) {
    if (component[v] == 1 && second < 0) second = static_cast<int>(v);
    components = std::max(components, component[v] + 1);
  }
  if (components > 1)
    defects.of_components.push_back(
        "the surface has " + std::to_string(components) + " components (the second begins at " +
        name_of_vertex(input, second) +
        "), one is wanted; try: --each-component (spin, flow, flatten), or a file for each");
  find_geometrical(input, defects);
  return defects;
}

std::string description(const CGP::Mesh_view& mesh)
{
  const auto t = CGP::topology(mesh);
  return "V " + std::to_string(t.vertices) + ", E " + std::to_string(t.edges) + ", F " +
         std::to_string(t.faces) + ", " +
         count_of(static_cast<std::size_t>(t.boundary_loops), "boundary loop") + ", genus " +
         std::to_string(t.genus);
}

void require_surface(const Surface_input& input, Flat_faces flat_faces)
{
  const std::string defect = find_defects(input).first(flat_faces);
  if (!defect.empty()) throw unsuitable(input.file.path, defect);
}

void require_surface_components(const Surface_input& input, Flat_faces flat_faces)
{
  Defects defects = find_defects(input);
  defects.of_components.clear();
  const std::string defect = defects.first(flat_faces);
  if (!defect.empty()) throw unsuitable(input.file.path, defect);
}

void require_closed_surface(const Surface_input& input)
{
  require_surface(input);
  const CGP::Mesh_view& mesh = input.mesh;
  std::vector<std::string> open;
  add_if_any(
      open, mesh.size_of_edges(),
      [&](int k) { return mesh.halfedges_end(k) - mesh.halfedges_begin(k) == 1; },
      [&](int k) { return name_of_edge(input, k); }, "boundary edge", "",
      "close the holes in a mesh editor");
  if (!open.empty())
    throw unsuitable(input.file.path, "a closed surface is wanted, this one has " +
                                          description(mesh) + ": " + open.front());
}

void require_untouched(const Surface_input& input)
{
  if (!input.notes.empty())
    throw unsuitable(input.file.path, input.notes.front() +
                                          ", which --strict forbids; try: "
                                          "without --strict");
}

}  // namespace conformal
