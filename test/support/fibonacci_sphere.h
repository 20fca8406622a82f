// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>

#include "support/random.h"
#include "support/scans.h"

namespace cgp_test {

/// n points of the unit sphere on the spiral of the golden angle, joined as Delaunay joins them: no
/// symmetry, hence no eigenvalue of the mesh is exactly multiple
Mesh_view fibonacci_sphere(int n);

}  // namespace cgp_test
