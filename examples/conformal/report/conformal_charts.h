// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Exhibit.h"

namespace conformal {

/// \brief Where a checkerboard is put onto any surface with its squares squares: maps to the plane
/// of least conformal energy, of a surface without handles that has a boundary as a whole, of
/// others in pieces.
///
/// Each piece has about as much area in the plane as on the surface, and the y axis points up in it
/// where it can. A piece that has no such map (its mesh is too poor) is seen along its mean normal.
Corner_places conformal_charts(const CGP::Mesh_view& mesh);

}  // namespace conformal
