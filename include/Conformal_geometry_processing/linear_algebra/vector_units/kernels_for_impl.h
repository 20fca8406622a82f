// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_KERNELS_FOR_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_KERNELS_FOR_IMPL_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/compiled_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/kernels_for.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/unit_kernels.h>

namespace Conformal_geometry_processing {

template <class Real>
Front_kernels<Real> kernels_for(int planes, [[maybe_unused]] Vector_unit unit)
{
#ifdef CGP_HAS_X86_UNITS
  if (unit == Vector_unit::avx512) return internal::compiled_kernels(Avx512_unit(), Real(), planes);
  if (unit == Vector_unit::avx2) return internal::compiled_kernels(Avx2_unit(), Real(), planes);
#endif
  return unit_kernels<Library_unit, Real>(planes);
}

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
template Front_kernels<double> kernels_for<double>(int, Vector_unit);
template Front_kernels<float> kernels_for<float>(int, Vector_unit);
#endif

}  // namespace Conformal_geometry_processing

#endif
