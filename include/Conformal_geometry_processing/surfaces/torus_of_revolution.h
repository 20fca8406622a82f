// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_TORUS_OF_REVOLUTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_TORUS_OF_REVOLUTION_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// a closed polygon in the half plane beside the axis: distances from it, positive, and heights
using Profile = Eigen::Matrix2Xd;

/// \ingroup PkgSurfaces
/// \brief the lengths of the edges of a profile over their distances from the axis: those of the
/// hyperbolic plane, but that the edges are straight.
///
/// A surface of revolution is conformally its profile in this length times 2 pi, so the torus has
/// the modulus i b, where 2 pi b or 2 pi / b is the sum.
/// \throw Precondition_error if there are fewer than three points, or one is not finite or not at a
/// positive distance
Eigen::VectorXd conformal_lengths(const Profile& profile);

/// \ingroup PkgSurfaces
/// \brief the profile, moved away from the axis or towards it until its torus has the modulus i b,
/// with the longer way around the axis if b > 1.
/// \throw Precondition_error if the profile is unsuitable, as for `conformal_lengths()`, or b is
/// not positive and finite
Profile profile_of_class(Profile profile, double b);

/// \ingroup PkgSurfaces
/// \brief the torus that a profile sweeps about the axis z, in faces near halves of one rectangle,
/// conformally.
/// \param profile counter-clockwise, if normals are to point outward; should be much finer than n
/// \param m, n how many vertices go around the axis, and around the tube
/// \throw Precondition_error if the profile is unsuitable, as for `conformal_lengths()`, or m or n
/// are below three
Mesh_view torus_of_revolution(const Profile& profile, int m, int n);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/surfaces/torus_of_revolution_impl.h>
#endif

#endif
