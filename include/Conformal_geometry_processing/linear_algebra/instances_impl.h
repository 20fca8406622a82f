// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_INSTANCES_IMPL_H

// Template instantiations of the compiled library, for its own solvers.

#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_eigen_decomposition_templates.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Dirichlet_solver_templates.h>

#include <complex>

namespace Conformal_geometry_processing {

template class internal::Dirichlet_solver<double>;
template class internal::Dirichlet_solver<Quaternion<double>>;
template internal::Hermitian_eigen_decomposition<double> hermitian_eigen_decomposition(
    Block<double>);
template internal::Hermitian_eigen_decomposition<std::complex<double>>
    hermitian_eigen_decomposition(Block<std::complex<double>>);
template internal::Hermitian_eigen_decomposition<Quaternion<double>> hermitian_eigen_decomposition(
    Block<Quaternion<double>>);

}  // namespace Conformal_geometry_processing

#endif
