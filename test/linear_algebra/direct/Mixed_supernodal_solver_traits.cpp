// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/linear_algebra/direct/Supernodal_cholesky.h
// Tests linear_algebra/direct/Supernodal_instances.h
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_cholesky.h>
#include <Conformal_geometry_processing/templates.h>

#include <gtest/gtest.h>

#include <complex>
#include <type_traits>

#include "linear_algebra/solver_laws.h"

namespace cgp_test {

template <class Scalar>
using Single = CGP::Supernodal_cholesky<Scalar, float>;

// A float has seven digits, and the condition numbers of these matrices cost up to two.
template <class Scalar>
inline constexpr double error_of_solution<Single<Scalar>> = 1e-5;

namespace {

using Traits = CGP::Mixed_supernodal_solver_traits;
static_assert(std::is_same_v<Traits::Solver<Quaternion<double>>, Single<Quaternion<double>>>);
static_assert(std::is_same_v<Traits::Solver<double>, CGP::Supernodal_cholesky<double>>);

using Models =
    testing::Types<Single<double>, Single<std::complex<double>>, Single<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Mixed, Hermitian_solver, Models);

}  // namespace
}  // namespace cgp_test
