// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "delaunay_faces.h"

#include "conformal/process/text.h"
#include "conformal/repair/select_faces.h"

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace conformal {
namespace {

/// in the numbers and the orientation of the file
Polygons triangles_in_file(const Surface_input& input, const CGP::Mesh_view& mesh)
{
  Polygons polygons;
  for (std::array<int, 3> corners : mesh.corners()) {
    if (input.is_turned_outward) std::swap(corners[1], corners[2]);
    for (const int v : corners)
      polygons.corners.push_back(input.vertex_in_file[static_cast<std::size_t>(v)]);
    polygons.first.push_back(polygons.corners.size());
  }
  return polygons;
}

/// whether two faces have the same corners, from whichever they begin
bool are_same(std::array<int, 3> a, std::array<int, 3> b)
{
  std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
  std::rotate(b.begin(), std::min_element(b.begin(), b.end()), b.end());
  return a == b;
}

/// Where a flip is, seams and textures would be torn.
void leave_out_corner_values(Surface_input& input)
{
  if (!input.file.texture.empty())
    input.file.notes.emplace_back("texture coordinates are left out, for edges were flipped");
  input.file.texture = {};
  input.file.normals = {};
}

}  // namespace

Delaunay_faces make_delaunay(Surface_input& input, double mollification)
{
  std::vector<std::array<int, 2>> flips;
  CGP::Mesh_view mesh = CGP::internal::delaunay_by_chords(input.mesh, mollification, flips);
  Delaunay_faces made{static_cast<int>(flips.size()), input.face_in_file, {}};
  if (flips.empty()) return made;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    if (!are_same(mesh.corners(f), input.mesh.corners(f))) made.changed.push_back(f);
  leave_out_corner_values(input);
  select_faces(input.file, {triangles_in_file(input, mesh), {}, {}, made.face_before});
  if (input.repair)
    for (int& f : made.face_before) f = input.repair->face_in_file[static_cast<std::size_t>(f)];
  if (input.repair) input.repair->face_in_file = made.face_before;
  std::iota(input.face_in_file.begin(), input.face_in_file.end(), 0);
  input.mesh = std::move(mesh);
  return made;
}

}  // namespace conformal
