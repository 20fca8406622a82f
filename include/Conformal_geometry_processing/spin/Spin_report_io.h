// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <ostream>

namespace Conformal_geometry_processing {

/// \relates Spin_report
/// writes the certificate, one fact per line
std::ostream& operator<<(std::ostream& out, const Spin_report& r);

}  // namespace Conformal_geometry_processing
