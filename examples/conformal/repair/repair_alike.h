// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "repair.h"

namespace conformal {

/// \brief Applies the operations of a repair to another file with the same vertices and faces, so
/// that the two stay in correspondence; the points of the first file determine the operations.
///
/// Elements removed from the first file must be negligible here: merged vertices must coincide (as
/// in the first, up to a millionth of the diagonal), and removed triangles must be flat (area at
/// most a millionth of the longest edge squared). Flipped edges, separated vertices and reversed
/// faces do not affect the correspondence.
/// \throws Failure naming the first element that violates this
/// \pre the file has the vertices and faces of `first.before`
void repair_alike(Surface_file& file, const Repair& first);

}  // namespace conformal
