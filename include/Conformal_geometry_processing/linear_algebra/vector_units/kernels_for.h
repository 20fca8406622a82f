// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_KERNELS_FOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_KERNELS_FOR_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/Front_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/Vector_unit.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Returns the kernels for scalars of 1, 2 or 4 real components.
///
/// \tparam Real the numbers stored, `double` or `float`
/// \pre `has_vector_unit(unit)`
template <class Real>
internal::Front_kernels<Real> kernels_for(int planes, internal::Vector_unit unit = vector_unit());

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
extern template internal::Front_kernels<double> kernels_for<double>(int, internal::Vector_unit);
extern template internal::Front_kernels<float> kernels_for<float>(int, internal::Vector_unit);
#endif

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/vector_units/kernels_for_impl.h>
#endif

#endif
