// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/surfaces/tori.h>

#include "support/mesh_tools.h"

/// Tori whose grid comes back to itself with a shift: no reflection keeps their conformal class
/// rectangular.
namespace cgp_test {

/// an elliptic cross-section that turns by pi around the axis: of no symmetry but rotations
Mesh_view twisted_torus(int n);

/// the Hopf torus over a curve near the equator that goes up and down three times: area 4 pi
Mesh_view hopf_torus(int n);

}  // namespace cgp_test
