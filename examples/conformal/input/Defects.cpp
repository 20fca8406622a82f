// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Defects.h"

#include "conformal/process/Failure.h"
#include "conformal/process/text.h"

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>

namespace conformal {
namespace {

using CGP::internal::Defect;

// `3 faces of area zero (first: face 7); try: ...`
std::string words_of(const Defect& defect, const std::string& first, const std::string& noun,
                     const std::string& what, const std::string& advice)
{
  return count_of(static_cast<std::size_t>(defect.count), noun) + what + " (first: " + first +
         "); try: " + advice;
}

void find_topological(const Surface_input& input, std::vector<std::string>& defects)
{
  const char* const advice = "cut the surface there, as --repair does";
  if (const Defect edges = CGP::internal::non_manifold_edges(input.mesh))
    defects.push_back(words_of(edges, name_of_edge(input, edges.first), "non-manifold edge",
                               " where more than two faces meet", advice));
  else if (!input.is_orientable)
    defects.emplace_back(
        "the surface is not orientable (one-sided, like a Moebius strip); try: cut it open, as "
        "--repair does");
  else if (const Defect vertices = CGP::internal::non_manifold_vertices(input.mesh))
    defects.push_back(words_of(vertices, name_of_vertex(input, vertices.first),
                               "non-manifold vertex", " where several fans of faces touch",
                               advice));
}

void find_components(const Surface_input& input, std::vector<std::string>& defects)
{
  if (const Defect further = CGP::internal::further_components(input.mesh))
    defects.push_back("the surface has " + std::to_string(further.count + 1) +
                      " components (the second begins at " + name_of_vertex(input, further.first) +
                      "), one is wanted; try: --each-component, where the command "
                      "has it, or conformal split");
}

Defect too_large(const CGP::Mesh_view& mesh)
{
  const double largest = 1e300;
  return CGP::internal::find_defect(
      Defect::Kind::vertex_out_of_range, mesh.size_of_vertices(),
      [&](int v) { return !(mesh.position(v).cwiseAbs().maxCoeff() <= largest); });
}

void find_geometrical(const Surface_input& input, Defects& found)
{
  const CGP::Mesh_view& mesh = input.mesh;
  std::vector<std::string>& defects = found.of_geometry;
  const Defect flat = CGP::internal::faces_of_area_zero(mesh);
  found.has_area = false;
  if (const Defect large = too_large(mesh)) {
    defects.push_back(words_of(large, name_of_vertex(input, large.first), "vertex",
                               " beyond the coordinate 1e300", "scale the mesh down"));
  } else if (flat.count == mesh.size_of_faces()) {
    defects.emplace_back("no face has an area, wanted a surface; try: another mesh");
  } else {
    found.has_area = true;
    if (flat)
      defects.push_back(
          words_of(flat, name_of_face(input, flat.first), "face", " of area zero",
                   std::string(input.repair ? "" : "--repair, which mends most of them, or ") +
                       "--mollify of spin, flow and fit, which takes them as they are"));
  }
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
  find_components(input, defects.of_components);
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
  const Defect open = CGP::internal::boundary_edges(input.mesh);
  if (open)
    throw unsuitable(input.file.path,
                     "a closed surface is wanted, this one has " + description(input.mesh) + ": " +
                         words_of(open, name_of_edge(input, open.first), "boundary edge", "",
                                  "close the holes in a mesh editor"));
}

void require_untouched(const Surface_input& input)
{
  if (!input.notes.empty())
    throw unsuitable(input.file.path, input.notes.front() +
                                          ", which --advanced strict forbids; try: "
                                          "without it");
}

}  // namespace conformal
