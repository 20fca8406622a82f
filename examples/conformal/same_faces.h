// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_SAME_FACES_H
#define CONFORMAL_SAME_FACES_H

#include "Surface_input.h"

#include <string>

namespace conformal {

/// \throws Failure unless the second file has the vertices and faces of the first, in number and
/// order
void require_same_faces(const Surface_file& first, const Surface_file& second);

/// where the vertices of the first are in the second
/// \pre they have the same faces
CGP::Points positions_in(const Surface_input& first, const Surface_file& second);

/// \brief Reads a surface with the faces of another: what a command takes beside its input, where
/// angles and areas matter.
/// \throws Failure if the faces are others or one has area zero; Read_error
Surface_input read_surface_like(const Surface_input& first, const std::string& path);

}  // namespace conformal

#endif
