// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>

namespace conformal {

/// Reads an OFF file (`OFF`, `COFF`, `NOFF`, `STOFF` and their combinations; ASCII).
///
/// Normals become the vertex properties `nx ny nz`, texture coordinates `texture_u texture_v`,
/// colours `red green blue [alpha]` (of type uchar if all are integers of 0..255, else double).
/// Colours of faces that are not three or four numbers on every face are kept as the list property
/// `color`. Other numbers after a vertex, and words that are none, are left out with a note.
/// O(bytes). \throws Read_error
Surface_file read_off(const std::string& path);

/// the same from memory; `path` is for messages
Surface_file parse_off(std::string_view bytes, const std::string& path,
                       Bad_faces bad_faces = Bad_faces::refused);

/// Number of bytes of the keyword with which an OFF header begins (`OFF`, `STCNOFF`, `4nOFF`, ...);
/// 0 if there is none.
std::size_t length_of_off_keyword(std::string_view text);

}  // namespace conformal
