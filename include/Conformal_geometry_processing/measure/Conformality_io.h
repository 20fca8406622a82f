// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_CONFORMALITY_IO_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_CONFORMALITY_IO_H

#include <Conformal_geometry_processing/measure/Conformality.h>

#include <iosfwd>

namespace Conformal_geometry_processing {
namespace internal {

/// \ingroup PkgMeasure
/// Writes the lines on conformality of a report, one fact per line
void print_conformality(std::ostream& out, const Conformality& c);

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/measure/Conformality_io_impl.h>
#endif

#endif
