// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>

#include "support/tori.h"

namespace cgp_test {

/// a torus with the connectivity of `torus(R, r, m, n)` whose cross-section, a figure eight or an
/// ellipse, turns `turns` times around the axis
Mesh_view turned_torus(int m, int n, bool is_eight, int turns);

}  // namespace cgp_test
