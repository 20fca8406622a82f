// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the weight alpha^2 of the distance to lambda = 1 for a surface with free boundary, in
/// 1/area: alpha = 10 h / R^2 with the mean edge length h and the area pi R^2.
///
/// If h << alpha R^2 << R, the solution tends to the projection of 1 onto the kernel of D - rho.
double nearness_weight(const Surface_ref& surface);

}  // namespace Conformal_geometry_processing
