// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Property.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

enum class Ply_encoding { ascii, little_endian, big_endian };

/// The contents of the header of a PLY file.
struct Ply_header {
  Ply_encoding encoding = Ply_encoding::ascii;
  std::vector<Element> elements;  // with their sizes, but with empty properties
  std::vector<std::size_t> element_lines;
  std::vector<std::string> comments, object_info;
  std::size_t bytes = 0;  // of the header: where the data begin
  std::size_t lines = 0;
};

/// Reads the header of a PLY file. \throws Read_error
Ply_header parse_ply_header(std::string_view bytes, const std::string& path);

}  // namespace conformal
