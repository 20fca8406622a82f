// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "select_faces.h"

#include "conformal/io/data/select_rows.h"

#include <algorithm>
#include <utility>

namespace conformal {

void append(Selected_faces& faces, const Surface_file& file, int face_in_file,
            const std::vector<std::size_t>& corners)
{
  for (const std::size_t c : corners) {
    faces.polygons.corners.push_back(file.polygons.corners[c]);
    if (!file.texture.index.empty()) faces.texture.push_back(file.texture.index[c]);
    if (!file.normals.index.empty()) faces.normals.push_back(file.normals.index[c]);
  }
  faces.polygons.first.push_back(faces.polygons.corners.size());
  faces.face_in_file.push_back(face_in_file);
}

void select_faces(Surface_file& file, Selected_faces faces)
{
  const std::vector<int>& origin = faces.face_in_file;
  for (Group_line& line : file.group_lines)
    line.face = static_cast<std::size_t>(
        std::lower_bound(origin.begin(), origin.end(), static_cast<int>(line.face)) -
        origin.begin());
  file.polygons = std::move(faces.polygons);
  if (!file.texture.index.empty()) file.texture.index = std::move(faces.texture);
  if (!file.normals.index.empty()) file.normals.index = std::move(faces.normals);
  file.faces = selected_rows(file.faces, origin);
}

}  // namespace conformal
