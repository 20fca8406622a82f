// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Surface_input.h"
#include "conformal/io/file/numbers.h"
#include "conformal/io/read_surface.h"
#include "conformal/repair/repair.h"

#include <string>
#include <utility>
#include <vector>

/// Meshes from lists, and their repair.
namespace program_test {

using Faces = std::vector<std::vector<int>>;

inline std::string off_of(const std::vector<conformal::Point>& points, const Faces& faces)
{
  std::string text =
      "OFF\n" + std::to_string(points.size()) + " " + std::to_string(faces.size()) + " 0\n";
  for (const conformal::Point& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      conformal::append_number(text, p[i]);
      text += i == 2 ? '\n' : ' ';
    }
  for (const auto& face : faces) {
    text += std::to_string(face.size());
    for (const int v : face) text += " " + std::to_string(v);
    text += "\n";
  }
  return text;
}

inline Faces faces_of(const conformal::Surface_file& file)
{
  Faces faces;
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    faces.emplace_back();
    for (std::size_t c = file.polygons.first[f]; c < file.polygons.first[f + 1]; ++c)
      faces.back().push_back(file.polygons.corners[c]);
  }
  return faces;
}

struct Repaired {
  conformal::Repair done;
  conformal::Surface_input input;
};

inline Repaired repaired(const std::string& text, const char* name = "a.off")
{
  conformal::Surface_file file = conformal::parse_surface(text, name, conformal::Bad_faces::kept);
  conformal::Repair done = conformal::repair(file);
  return {std::move(done), conformal::prepare(std::move(file))};
}

}  // namespace program_test
