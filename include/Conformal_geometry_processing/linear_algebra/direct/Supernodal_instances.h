// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>

#include <complex>

/// \file
/// Lists the instances in the compiled library.

/// `Supernodal_cholesky`: apply(Scalar)
#define CGP_FOR_SUPERNODAL_SCALARS(apply)                                          \
  apply(double) apply(std::complex<double>) apply(Quaternion<double>) apply(float) \
      apply(Quaternion<float>)

/// `Supernodal_factor` and `Supernodal_substitution`: apply(Scalar, Real) for each combination of
/// matrix entries and numbers of the factor
#define CGP_FOR_SUPERNODAL_INSTANCES(apply)                                                    \
  apply(double, double) apply(std::complex<double>, double) apply(Quaternion<double>, double)  \
      apply(double, float) apply(std::complex<double>, float) apply(Quaternion<double>, float) \
          apply(float, float) apply(Quaternion<float>, float)

/// those of them with real entries
#define CGP_FOR_REAL_SUPERNODAL_INSTANCES(apply) \
  apply(double, double) apply(double, float) apply(float, float)
