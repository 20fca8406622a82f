// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Ply_header.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// An element of a PLY file with its values and, of ASCII files, the line that each row begins on.
struct Ply_element : Element {
  std::vector<std::size_t> lines;
};

/// Reads the values that follow a PLY header. Every count is checked against the bytes left before
/// anything is allocated.
///
/// ASCII values are taken one after the other, wherever the lines end. If that fails and every row
/// of an element has a line with equally many values more than the header announces (as in files
/// of MeshLab with wedge colours), those are left out, with a note. \throws Read_error
std::vector<Ply_element> parse_ply_body(std::string_view bytes, const std::string& path,
                                        const Ply_header& header, std::vector<std::string>& notes);

}  // namespace conformal
