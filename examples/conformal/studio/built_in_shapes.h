// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Studio_shape.h"

#include <vector>

namespace conformal {

/// surfaces to try the studio on: a creature with limbs, a sphere, a torus, a disk; about 5000
/// faces each
std::vector<Studio_shape> built_in_shapes();

}  // namespace conformal
