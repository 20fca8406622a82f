// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Surface_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// a surface that the page offers
struct Studio_shape {
  std::string name;  ///< for the user
  std::string file;  ///< for command lines
  CGP::Mesh_view mesh;
  std::vector<int> vertex_in_file = {};  ///< of each vertex of the mesh; empty: as in the mesh
  int file_vertices = 0;                 ///< their number in the file, where that is different
  bool is_repaired = false;              ///< the file, by --repair
  std::vector<std::string> notes = {};   ///< what was done to it, for the user
};

/// the surface of a file, which is one surface as the studio wants it
Studio_shape shape_of(const Surface_input& input);

/// \brief The surface of a file that was dropped on the page.
/// \param name of the file
/// \throws Read_error, and Failure for what is not one oriented manifold surface with positive
/// areas
Studio_shape parse_shape(std::string_view bytes, const std::string& name, bool is_repaired);

/// where its squares are, two numbers of each corner
std::vector<float> squares_of(const Studio_shape& shape);

}  // namespace conformal
