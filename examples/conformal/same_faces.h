// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_SAME_FACES_H
#define CONFORMAL_SAME_FACES_H

#include "Surface_input.h"

namespace conformal {

/// \throws Failure unless the second file has the vertices and faces of the first, in number and
/// order
void require_same_faces(const Surface_file& first, const Surface_file& second);

/// where the vertices of the first are in the second
/// \pre they have the same faces
CGP::Points positions_in(const Surface_input& first, const Surface_file& second);

}  // namespace conformal

#endif
