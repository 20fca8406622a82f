// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Component.h"

#include "conformal/process/text.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <numeric>
#include <utility>

namespace conformal {
namespace {

std::vector<int> selected(const std::vector<int>& values, const std::vector<int>& indices)
{
  std::vector<int> result;
  for (const int i : indices) result.push_back(values[static_cast<std::size_t>(i)]);
  return result;
}

/// of these elements the numbers in the file of the user, before it was repaired
std::vector<int> numbers_in_file(const Surface_input& input, const std::vector<int>& in_file,
                                 std::vector<int> Repair::*before, const std::vector<int>& elements)
{
  const std::vector<int> now = selected(in_file, elements);
  return input.repair ? selected((*input.repair).*before, now) : now;
}

std::vector<int> first_numbers(int count)
{
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// whether it is closed and has a negative volume; it may be no manifold
bool is_inside_out(const CGP::Mesh_view& mesh)
{
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    if (mesh.halfedges_end(k) - mesh.halfedges_begin(k) != 2) return false;
  return CGP::signed_volume(CGP::internal::in_own_frame(mesh)) < 0;
}

}  // namespace

CGP::internal::Mesh_component whole_of(const CGP::Mesh_view& mesh)
{
  return {mesh, first_numbers(mesh.size_of_vertices()), first_numbers(mesh.size_of_faces())};
}

Surface_input reordered(CGP::internal::Mesh_component& all, Surface_input whole)
{
  whole.mesh = std::move(all.mesh);
  whole.vertex_in_file = selected(whole.vertex_in_file, all.vertices);
  whole.face_in_file = selected(whole.face_in_file, all.faces);
  return whole;
}

Surface_input input_of(const CGP::internal::Mesh_component& part, const Surface_input& whole)
{
  Surface_input input;
  input.file.path = whole.file.path;
  input.file.format = whole.file.format;
  input.mesh = part.mesh;
  input.vertex_in_file =
      numbers_in_file(whole, whole.vertex_in_file, &Repair::vertex_in_file, part.vertices);
  input.face_in_file =
      numbers_in_file(whole, whole.face_in_file, &Repair::face_in_file, part.faces);
  return input;
}

void turn_components_outward(Surface_input& input)
{
  auto corners = input.mesh.corners();
  std::size_t count = 0;
  for (const CGP::internal::Mesh_component& part : CGP::mesh_components(input.mesh)) {
    if (!is_inside_out(part.mesh)) continue;
    ++count;
    for (const int f : part.faces)
      std::swap(corners[static_cast<std::size_t>(f)][1], corners[static_cast<std::size_t>(f)][2]);
  }
  if (count == 0) return;
  input.mesh = CGP::Mesh_view(input.mesh.positions(), std::move(corners));
  input.notes.push_back(count_of(count, "component") +
                        " inside out: computed with outward normals, faces are written as they "
                        "were");
}

}  // namespace conformal
