// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Reduced_basis.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the constant spins that turn the directions at the boundary into the prescribed ones: an
/// orthonormal basis over the reals of the quaternions q with q = B B^T q, at most four.
///
/// Kept directions admit 1 and, if they are all parallel, as the binormals of a cylinder are, the
/// rotations about them.
Vector<Quaternion<double>> constant_spins(const internal::Reduced_basis<double>& basis);

}  // namespace Conformal_geometry_processing
