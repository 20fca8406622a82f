// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>

#include "support/polyhedra.h"

/// A beam, and what can be done to it.
namespace cgp_test {

/// the block 1 x 1 x 6 with n quads along its short edges
Mesh_view beam(int n);

/// the beam as the arc of a circle by an angle; in the plane y = `neutral` lengths stay
Mesh_view bent_beam(const Mesh_view& mesh, double angle, double neutral = 0);

/// the beam with its end turned about its axis by an angle
Mesh_view twisted_beam(const Mesh_view& mesh, double angle);

}  // namespace cgp_test
