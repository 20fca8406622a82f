// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>

#include <iosfwd>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMeasure
/// Writes the lines on conformality of a report, one fact per line
void print_conformality(std::ostream& out, const Conformality& c);

}  // namespace Conformal_geometry_processing::internal
