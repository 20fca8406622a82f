// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// how far a format distinguishes the corners of a vertex
enum class Detail { none, vertices, corners };

/// What is written of a file, besides points and the corners of faces.
struct Written {
  const char* format;
  std::vector<std::string> vertices = {}, faces = {};  // names of properties; texture apart
  Detail texture = Detail::none, normals = Detail::none;
  bool has_polygons = true;  // faces of more than three corners
  bool has_comments = false, has_groups = false, has_elements = false;
  bool has_three_texture_coordinates = false, has_object_info = false;
};

/// A note for everything in a file that is not written: one list for all formats.
void note_losses(const Surface_file& file, const Written& written, std::vector<std::string>& notes);

}  // namespace conformal
