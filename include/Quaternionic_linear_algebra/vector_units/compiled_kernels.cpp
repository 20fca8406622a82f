// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The kernels of one vector unit. A source file of the library that is compiled for the unit
// defines CGP_VECTOR_UNIT, the name of its tag, and includes only this file: no Eigen, and no
// standard headers that define functions, which a linker could merge with those of other files.
#include <Quaternionic_linear_algebra/vector_units/compiled_kernels.h>

#ifdef CGP_VECTOR_UNIT

namespace Conformal_geometry_processing::internal {

Front_kernels<double> compiled_kernels(CGP_VECTOR_UNIT, double, int planes)
{
  return unit_kernels<CGP_VECTOR_UNIT, double>(planes);
}

Front_kernels<float> compiled_kernels(CGP_VECTOR_UNIT, float, int planes)
{
  return unit_kernels<CGP_VECTOR_UNIT, float>(planes);
}

}  // namespace Conformal_geometry_processing::internal

#endif
