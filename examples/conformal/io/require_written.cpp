// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "require_written.h"

#include "read_surface.h"

#include "conformal/io/file/io_errors.h"

#include <algorithm>
#include <cmath>

namespace conformal {
namespace {

/// the corners of all faces, polygons as fans of triangles
std::vector<const Point*> corners_of(const Surface_file& file)
{
  std::vector<const Point*> corners;
  const auto add = [&](std::size_t c) {
    corners.push_back(&file.points[static_cast<std::size_t>(file.polygons.corners[c])]);
  };
  const auto& first = file.polygons.first;
  for (std::size_t f = 0; f < file.polygons.size(); ++f)
    for (std::size_t c = first[f] + 2; c < first[f + 1]; ++c) {
      add(first[f]);
      add(c - 1);
      add(c);
    }
  return corners;
}

double distance(const Point& p, const Point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// of the bounding box
double diagonal(const std::vector<const Point*>& corners)
{
  Point low = *corners.front(), high = low;
  for (const Point* point : corners)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], (*point)[i]);
      high[i] = std::max(high[i], (*point)[i]);
    }
  return distance(low, high);
}

Surface_file read_again(const std::string& path, std::string_view bytes)
{
  try {
    return parse_surface(bytes, path, Bad_faces::kept);
  } catch (const Read_error& error) {
    throw Write_error(path, std::string("what was to be written cannot be read: ") + error.what());
  }
}

/// faces with a side whose length differs by more than a tenth
std::size_t distorted(const std::vector<const Point*>& before,
                      const std::vector<const Point*>& after)
{
  std::size_t count = 0;
  for (std::size_t c = 0; c < before.size(); c += 3) {
    const auto is_another = [&](std::size_t i, std::size_t k) {
      const double length = distance(*before[c + i], *before[c + k]);
      return std::abs(distance(*after[c + i], *after[c + k]) - length) > length / 10;
    };
    count += is_another(0, 1) || is_another(1, 2) || is_another(2, 0);
  }
  return count;
}

}  // namespace

void require_written(const std::string& path, const Surface_file& meant, std::string_view bytes,
                     std::vector<std::string>& notes, Value_type coordinates_of_ply)
{
  const Surface_file read = read_again(path, bytes);
  const std::vector<const Point*> before = corners_of(meant), after = corners_of(read);
  if (before.size() != after.size())
    throw Write_error(path, std::to_string(after.size() / 3) + " triangles were written, wanted " +
                                std::to_string(before.size() / 3));
  if (before.empty()) return;
  const bool is_single =
      read.format == File_format::glb || read.format == File_format::gltf ||
      read.format == File_format::stl ||
      (read.format == File_format::ply && coordinates_of_ply == Value_type::float32);
  const double allowed = is_single ? 1e-6 * diagonal(before) : 0;
  for (std::size_t c = 0; c < before.size(); ++c)
    if (!(distance(*before[c], *after[c]) <= allowed))
      throw Write_error(
          path,
          "a corner of triangle " + std::to_string(c / 3) + " does not fit into " +
              (is_single ? "single precision; try: .ply without --advanced float" : "the file"));
  const std::size_t count = is_single ? distorted(before, after) : 0;
  if (count > 0)
    notes.push_back("single precision distorts " + std::to_string(count) +
                    " triangles by more than a tenth");
}

}  // namespace conformal
