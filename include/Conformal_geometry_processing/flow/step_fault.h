// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Flow_options.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief why a step of a flow must be rejected whatever its energy; empty if it may be accepted.
///
/// \param report of the spin transformation of the step
/// \param is_turning whether the boundary has not yet reached the prescribed directions. Tangents
/// that are merely kept need not be realizable: if they are not planar, no curvature is.
/// \param is_exact whether the surface is to stay on its exact conformal class
std::string step_fault(const Spin_report& report, bool is_turning, bool is_exact,
                       const Flow_options& options);

}  // namespace Conformal_geometry_processing
