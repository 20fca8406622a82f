// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>

#include "support/meshes.h"

/// Surfaces with limbs, on which rho adds up to large scales, and rings of curvature along them.
namespace cgp_test {

/// two balls with a neck between them along y, irregular
Mesh_view dumbbell(int level);

Eigen::VectorXd rings(const Mesh_view& mesh, double amplitude, double frequency);

}  // namespace cgp_test
