// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_REPAIR_ALIKE_H
#define CONFORMAL_REPAIR_ALIKE_H

#include "repair.h"

namespace conformal {

/// \brief Does to a file what was done to another with the same vertices and faces, so that the two
/// stay in correspondence: whatever the first one's points decided is done here, too.
///
/// What disappeared from the first must be next to nothing here: vertices that are one now must
/// have been together (as in the first, but for a millionth of the diagonal), and triangles that
/// were removed must have been flat (area at most a millionth of the longest edge squared). Edges
/// that were flipped, vertices that were separated and faces that were turned harm no
/// correspondence.
/// \throws Failure naming the first element for which that is not so
/// \pre the file has the vertices and faces of `first.before`
void repair_alike(Surface_file& file, const Repair& first);

}  // namespace conformal

#endif
