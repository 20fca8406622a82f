// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// A closed polygon in the half plane beside the axis: positive distances from it, and heights
using Profile = Eigen::Matrix2Xd;

}  // namespace internal

/// \ingroup PkgSurfaces
/// \brief Returns the lengths of the edges of a profile divided by their distances from the axis:
/// approximately hyperbolic lengths, with straight edges.
///
/// A surface of revolution is conformal to its profile in this length times 2 pi, so the torus has
/// the modulus i b, where 2 pi b or 2 pi / b is the sum.
/// \throw Precondition_error if there are fewer than three points, or one is not finite or not at a
/// positive distance
Eigen::VectorXd conformal_lengths(const internal::Profile& profile);

/// \ingroup PkgSurfaces
/// \brief Moves a profile away from or towards the axis such that its torus has the modulus i b,
/// where the longer direction is around the axis if b > 1.
/// \throw Precondition_error if the profile is unsuitable, as for `conformal_lengths()`, or b is
/// not positive and finite
internal::Profile profile_of_class(internal::Profile profile, double b);

/// \ingroup PkgSurfaces
/// \brief Creates the torus that a profile sweeps about the axis z, with faces that are, up to
/// discretization, conformal to halves of one rectangle.
/// \param profile counter-clockwise for outward normals; should be much finer than n
/// \param m, n number of vertices around the axis, and around the tube
/// \throw Precondition_error if the profile is unsuitable, as for `conformal_lengths()`, or m or n
/// are below three
Mesh_view torus_of_revolution(const internal::Profile& profile, int m, int n);

}  // namespace Conformal_geometry_processing
