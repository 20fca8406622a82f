// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Reduced_basis.h>

#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

using Boundary_plane = Reduced_basis<double>::Plane;

}  // namespace internal

/// \ingroup PkgSpin
/// \brief unit quaternions, one in each plane along a closed loop, that turn as little as possible
/// from one to the next: transported without twist, with the mismatch where the loop closes
/// distributed evenly, and all rotated in their planes to be nearest to q.
///
/// With the smallest rotations of one direction into another, the two ends of the loop may be
/// opposite quaternions of one rotation. This cannot happen here, because a plane contains q, -q
/// and everything between. O(n).
/// \param planes orthonormal bases; (q, -q V) with V on the same side of all, as
/// `boundary_plane()` makes them
std::vector<Quaternion<double>> least_twist(
    const std::vector<internal::Reduced_basis<double>::Plane>& planes, const Quaternion<double>& q);

}  // namespace Conformal_geometry_processing
