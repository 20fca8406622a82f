// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Session.h"

#include "conformal/input/Surface_input.h"

namespace conformal {

/// \brief Stores both shapes for the HTML report, if one is requested. To be called before the
/// surface is written, because it takes memory and time.
///
/// The squares are those of the texture coordinates of the file, if it has any; otherwise of
/// conformal maps to the plane, of the whole surface or of pieces of it.
void keep_exhibit(const Surface_input& before, const CGP::Points& after, Session& session);

/// Likewise for a map to the plane z = 0, which defines the squares
void keep_flat_exhibit(const Surface_input& before, const CGP::Points& after, Session& session);

}  // namespace conformal
