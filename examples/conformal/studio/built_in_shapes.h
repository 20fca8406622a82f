// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_STUDIO_BUILT_IN_SHAPES_H
#define CONFORMAL_STUDIO_BUILT_IN_SHAPES_H

#include "studio_page.h"

#include <vector>

namespace conformal {

/// surfaces to try the studio on: a creature with limbs, a sphere, a torus, a disk; about 5000
/// faces each
std::vector<Studio_shape> built_in_shapes();

}  // namespace conformal

#endif
