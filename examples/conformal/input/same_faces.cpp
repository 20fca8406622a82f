// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "same_faces.h"

#include "conformal/io/read_surface.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"
#include "conformal/repair/repair_alike.h"

#include <cstddef>
#include <utility>

namespace conformal {
namespace {

std::string corners_of(const Polygons& polygons, std::size_t f)
{
  std::string text;
  for (std::size_t c = polygons.first[f]; c < polygons.first[f + 1]; ++c)
    text += (text.empty() ? "" : " ") + std::to_string(polygons.corners[c]);
  return text;
}

bool is_repaired(const Surface_input& input)
{
  return input.repair && input.repair->has_changed_anything();
}

}  // namespace

void require_same_faces(const Surface_file& first, const Surface_file& second)
{
  const auto different = [&](const std::string& difference) {
    return unsuitable(second.path, "has not the faces of " + first.path + ": " + difference +
                                       "; try: a mesh computed from it");
  };
  const auto numbers = [](const std::string& noun, std::size_t n, std::size_t wanted) {
    return count_of(n, noun) + ", wanted " + std::to_string(wanted);
  };
  const Polygons &a = first.polygons, &b = second.polygons;
  if (first.points.size() != second.points.size())
    throw different(numbers("vertex", second.points.size(), first.points.size()));
  if (a.size() != b.size()) throw different(numbers("face", b.size(), a.size()));
  for (std::size_t f = 0; f < a.size(); ++f)
    if (corners_of(a, f) != corners_of(b, f))
      throw different("face " + std::to_string(f) + " has the vertices " + corners_of(b, f) +
                      ", wanted " + corners_of(a, f));
}

CGP::Points positions_in(const Surface_input& first, const Surface_file& second)
{
  CGP::Points points(3, first.mesh.size_of_vertices());
  for (int v = 0; v < first.mesh.size_of_vertices(); ++v) {
    const int i = first.vertex_in_file[static_cast<std::size_t>(v)];
    points.col(v) = Eigen::Vector3d::Map(second.points[static_cast<std::size_t>(i)].data());
  }
  return points;
}

Surface_file read_file_like(const Surface_input& first, const std::string& path)
{
  if (!is_repaired(first)) {
    Surface_file file = read_surface_input(path).file;
    require_same_faces(first.file, file);
    return file;
  }
  Surface_file file = read_surface(path == "-" ? "/dev/stdin" : path, Bad_faces::kept);
  require_same_faces(first.repair->before, file);
  repair_alike(file, *first.repair);
  return prepare(std::move(file)).file;
}

std::vector<std::string> notes_of_repair_alike(const Surface_input& first,
                                               const std::vector<std::string>& paths)
{
  std::vector<std::string> notes;
  for (const std::string& path : paths)
    if (is_repaired(first) && !path.empty())
      notes.push_back(path + ": repaired like " + first.file.path +
                      ", each vertex and face as the one of the same number there");
  return notes;
}

Surface_input read_surface_like(const Surface_input& first, const std::string& path,
                                Flat_faces flat_faces)
{
  Surface_input second = first;
  second.file = read_file_like(first, path);
  second.mesh.set_positions(positions_in(first, second.file));
  const Defects defects = find_defects(second);
  const bool is_flat_only = defects.has_area && flat_faces == Flat_faces::allowed;
  if (!defects.of_geometry.empty() && !is_flat_only)
    throw unsuitable(path, defects.of_geometry.front());
  return second;
}

}  // namespace conformal
