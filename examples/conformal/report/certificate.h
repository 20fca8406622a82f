// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Outcome.h"

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Tells the certificate of a solution of the Dirac equation, and the seconds it took.
void tell_certificate(const CGP::Spin_report& spin, int faces, Outcome& outcome);
void add_seconds(const CGP::Spin_report& spin, Stage_seconds& seconds);

/// Tells the part that concerns the map only.
void tell_conformality(const CGP::Conformality& map, int faces, Report& report);

/// Tells by which factors lengths have changed, if there is a bound on them.
void tell_scales(const CGP::Spin_report::Scales& scales, Report& report);

/// Tells how the triangulation of a mollified surface was built; nothing of another.
void tell_mollification(const CGP::Spin_report::Mollification& made, Report& report);

}  // namespace conformal
