// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Plane_curve.h"

namespace conformal {

/// \brief Divides edges into equal parts until none is longer than 1 / count of the whole curve,
/// because edges remain straight.
/// \pre count > 0
void refine(Plane_curve& curve, int count);

}  // namespace conformal
