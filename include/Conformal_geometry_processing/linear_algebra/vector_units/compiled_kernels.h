// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/vector_units/Front_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/unit_tags.h>

namespace Conformal_geometry_processing::internal {

// The kernels of the compiled library for units other than the baseline. Not templates, because
// only the file that is compiled for a unit may instantiate them.
Front_kernels<double> compiled_kernels(Avx2_unit, double, int planes);
Front_kernels<float> compiled_kernels(Avx2_unit, float, int planes);
Front_kernels<double> compiled_kernels(Avx512_unit, double, int planes);
Front_kernels<float> compiled_kernels(Avx512_unit, float, int planes);

}  // namespace Conformal_geometry_processing::internal
