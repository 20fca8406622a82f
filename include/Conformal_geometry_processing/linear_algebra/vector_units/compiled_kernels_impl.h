// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_COMPILED_KERNELS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_COMPILED_KERNELS_IMPL_H

// The kernels of one vector unit. A source file of the library that is compiled for the unit
// defines CGP_VECTOR_UNIT, the name of its tag, and includes only this file: no Eigen, and no
// standard headers that define functions, which a linker could merge with those of other files.

#ifdef CGP_VECTOR_UNIT

#include <Conformal_geometry_processing/linear_algebra/vector_units/compiled_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/unit_kernels.h>

namespace Conformal_geometry_processing {
namespace internal {

Front_kernels<double> compiled_kernels(CGP_VECTOR_UNIT, double, int planes)
{
  return unit_kernels<CGP_VECTOR_UNIT, double>(planes);
}

Front_kernels<float> compiled_kernels(CGP_VECTOR_UNIT, float, int planes)
{
  return unit_kernels<CGP_VECTOR_UNIT, float>(planes);
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif

#endif
