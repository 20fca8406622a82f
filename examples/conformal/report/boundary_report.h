// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Report.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Tells what came of a condition at the boundary (`result/boundary/...`); nothing of closed
/// surfaces.
void tell_boundary(const CGP::Mesh_view& mesh, const CGP::Boundary_condition& condition,
                   const CGP::Spin_report& spin, Report& report);

}  // namespace conformal
