// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Report.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <cstddef>
#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Tells how far control points have come on the way to their targets.
/// \param count of the control points
void tell_targets(const CGP::Spin_report& spin, std::size_t count, Report& report);

/// Tells how conformal the collar of a region is, where a deformation fades out.
void tell_collar(const CGP::Conformality& collar, Report& report);

/// why a surface is refused that is not at its targets, with what to try; empty if it is near
/// enough
std::string fault_of_targets(const CGP::Spin_report& spin, const CGP::Spin_report::Limits& limits);

}  // namespace conformal
