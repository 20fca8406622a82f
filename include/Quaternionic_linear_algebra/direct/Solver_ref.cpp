// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

namespace Conformal_geometry_processing::internal {

template <class Scalar>
Solver_pointer<Scalar> make_default_solver()
{
  return Solver_model<Default_solver_traits, Scalar>::make();
}

template Solver_pointer<double> make_default_solver();
template Solver_pointer<std::complex<double>> make_default_solver();
template Solver_pointer<Quaternion<double>> make_default_solver();

}  // namespace Conformal_geometry_processing::internal
