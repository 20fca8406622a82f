// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace conformal {

/// A surface as graphics hardware takes it: one index per corner, so that a vertex on a seam of the
/// texture has copies; they come after all vertices. Empty vectors stand for what there is not.
struct Glb_mesh {
  Point middle{};  // of the bounding box; positions are relative to it
  std::vector<std::array<float, 3>> positions, normals;
  std::vector<std::array<float, 2>> texture;            // (u, 1 - v)
  std::vector<std::array<unsigned char, 4>> colors;     // red, green, blue, alpha
  std::vector<std::array<std::uint32_t, 3>> triangles;  // polygons as fans

  /// a property of the vertices that stands for no normals, colours or texture coordinates
  struct Values {
    std::string property, attribute;  // names
    std::vector<std::array<float, 1>> rows;
  };
  std::vector<Values> values;
};

Glb_mesh glb_mesh(const Surface_file& file);

}  // namespace conformal
