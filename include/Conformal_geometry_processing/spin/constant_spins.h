// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CONSTANT_SPINS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CONSTANT_SPINS_H

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

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/constant_spins_impl.h>
#endif

#endif
