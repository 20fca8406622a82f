// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_REPORT_IO_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_REPORT_IO_H

#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <ostream>

namespace Conformal_geometry_processing {

/// \relates Spin_report
/// writes the certificate, one fact per line
std::ostream& operator<<(std::ostream& out, const Spin_report& r);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Spin_report_io_impl.h>
#endif

#endif
