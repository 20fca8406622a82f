// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "support/mesh_tools.h"

namespace cgp_test {

/// the inversion in the unit sphere around `center`, with a reflection so that it keeps orientation
Mesh_view inverted(const Mesh_view& mesh, const Eigen::Vector3d& center);

}  // namespace cgp_test
