// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_LEAST_TWIST_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_LEAST_TWIST_H

#include <Conformal_geometry_processing/algebra/Reduced_basis.h>

#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

using Boundary_plane = Reduced_basis<double>::Plane;

}  // namespace internal

/// \ingroup PkgSpin
/// \brief unit quaternions, one in each plane along a closed loop, that turn in their planes as
/// little as they can from one to the next: carried along without twist, what is missing where the
/// loop closes spread evenly, and all of them turned such that they are near to q.
///
/// Of the smallest rotations of one direction into another, which seem the natural choice, those
/// at the two ends of the loop may be opposite quaternions of one rotation; these never are, for a
/// plane contains q and -q with all between. O(n).
/// \param planes orthonormal bases; (q, -q V) with the same V on one side of all, as
/// `boundary_plane()` makes them
std::vector<Quaternion<double>> least_twist(const std::vector<Reduced_basis<double>::Plane>& planes,
                                            const Quaternion<double>& q);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/least_twist_impl.h>
#endif

#endif
