// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_KERNELS_FOR_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_KERNELS_FOR_IMPL_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/compiled_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/kernels_for.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/unit_kernels.h>

namespace Conformal_geometry_processing {

template <class Real>
internal::Front_kernels<Real> kernels_for(int planes, [[maybe_unused]] internal::Vector_unit unit)
{
#ifdef CGP_HAS_X86_UNITS
  if (unit == internal::Vector_unit::avx512)
    return internal::compiled_kernels(internal::Avx512_unit(), Real(), planes);
  if (unit == internal::Vector_unit::avx2)
    return internal::compiled_kernels(internal::Avx2_unit(), Real(), planes);
#endif
  return unit_kernels<internal::Library_unit, Real>(planes);
}

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
template internal::Front_kernels<double> kernels_for<double>(int, internal::Vector_unit);
template internal::Front_kernels<float> kernels_for<float>(int, internal::Vector_unit);
#endif

}  // namespace Conformal_geometry_processing

#endif
