// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DEFAULT_SOLVER_TRAITS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DEFAULT_SOLVER_TRAITS_H

#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#include <Conformal_geometry_processing/linear_algebra/Cholmod_hermitian_solver_traits.h>
#else
#include <Conformal_geometry_processing/linear_algebra/Eigen_hermitian_solver_traits.h>
#endif

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the solvers used when none are named: those of CHOLMOD where the component `cholmod` is
/// linked, which defines `CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD`, else those of Eigen.
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
using Default_solver_traits = Cholmod_hermitian_solver_traits;
#else
using Default_solver_traits = Eigen_hermitian_solver_traits;
#endif

}  // namespace Conformal_geometry_processing

#endif
