// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <complex>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief Returns the spherical harmonic Y_l^m, orthonormal on the unit sphere, with the
/// Condon-Shortley phase: Y_l^-m = (-1)^m conj(Y_l^m). Zero if |m| > l or l < 0.
/// \param point not zero; only its direction is used
std::complex<double> spherical_harmonic(int l, int m, const Eigen::Vector3d& point);

}  // namespace Conformal_geometry_processing
