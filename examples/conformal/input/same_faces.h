// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Defects.h"
#include "Surface_input.h"

#include <string>
#include <vector>

namespace conformal {

/// \throws Failure unless the second file has the vertices and faces of the first, in number and
/// order
void require_same_faces(const Surface_file& first, const Surface_file& second);

/// where the vertices of the first are in the second
/// \pre they have the same faces
CGP::Points positions_in(const Surface_input& first, const Surface_file& second);

/// \brief Reads a file with the vertices and faces of another. If that one was repaired, the same
/// is done to this one, see `repair_alike()`.
/// \throws Failure if the faces are others, or cannot be repaired alike; Read_error
Surface_file read_file_like(const Surface_input& first, const std::string& path);

/// A note for each file that was repaired like the first, if that was; empty names are none.
std::vector<std::string> notes_of_repair_alike(const Surface_input& first,
                                               const std::vector<std::string>& paths);

/// \brief Reads a surface with the faces of another one, like `read_file_like()`: the second input
/// of commands for which angles and areas matter.
/// \throws Failure also if a face has area zero and that is not allowed
Surface_input read_surface_like(const Surface_input& first, const std::string& path,
                                Flat_faces flat_faces = Flat_faces::refused);

}  // namespace conformal
