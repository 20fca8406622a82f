// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SOLVER_REF_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SOLVER_REF_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>

#include <complex>

namespace Conformal_geometry_processing {
namespace internal {

template <>
CGP_INLINE Solver_pointer<double> make_default_solver()
{
  return Solver_model<Default_solver_traits, double>::make();
}

template <>
CGP_INLINE Solver_pointer<std::complex<double>> make_default_solver()
{
  return Solver_model<Default_solver_traits, std::complex<double>>::make();
}

template <>
CGP_INLINE Solver_pointer<Quaternion<double>> make_default_solver()
{
  return Solver_model<Default_solver_traits, Quaternion<double>>::make();
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
