// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_TORUS_OF_REVOLUTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_TORUS_OF_REVOLUTION_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/surfaces/evenly_spaced.h>
#include <Conformal_geometry_processing/surfaces/torus_grid.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

/// a closed polygon in the half plane beside the axis: distances from it, positive, and heights
using Profile = Eigen::Matrix2Xd;

namespace internal {

inline void require_profile(const Profile& profile, const std::string& function)
{
  if (profile.cols() < 3 || !profile.allFinite() || !(profile.row(0).array() > 0).all())
    throw Precondition_error(function,
                             "the profile has " + std::to_string(profile.cols()) +
                                 " points; wanted three at least, all of them finite and at "
                                 "positive distances from the axis");
}

}  // namespace internal

/// \ingroup PkgSurfaces
/// \brief the lengths of the edges of a profile over their distances from the axis: those of the
/// hyperbolic plane, but that the edges are straight.
///
/// A surface of revolution is conformally its profile in this length times 2 pi, so the torus has
/// the modulus i b, where 2 pi b or 2 pi / b is the sum.
/// \throw Precondition_error if there are fewer than three points, or one is not finite or not at a
/// positive distance
inline Eigen::VectorXd conformal_lengths(const Profile& profile)
{
  internal::require_profile(profile, "conformal_lengths");
  const Eigen::Index n = profile.cols();
  Eigen::VectorXd lengths(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d edge = profile.col((i + 1) % n) - profile.col(i);
    const double x = profile(0, i), t = edge[0] / x;
    lengths[i] = edge.norm() / x * (std::abs(t) < 1e-9 ? 1 : std::log1p(t) / t);
  }
  return lengths;
}

/// \ingroup PkgSurfaces
/// \brief the profile, moved away from the axis or towards it until its torus has the modulus i b,
/// with the longer way around the axis if b > 1.
/// \throw Precondition_error if the profile is unsuitable, as for `conformal_lengths()`, or b is
/// not positive and finite
inline Profile profile_of_class(Profile profile, double b)
{
  internal::require_profile(profile, "profile_of_class");
  if (!(b > 0 && std::isfinite(b)))
    throw Precondition_error("profile_of_class",
                             "the modulus is " + std::to_string(b) + " i, wanted b positive");
  const Eigen::RowVectorXd x = profile.row(0).array() - profile.row(0).minCoeff();
  const double wanted = 8 * std::atan(1.) / b;
  const auto excess = [&](double gap) {
    profile.row(0) = x.array() + gap;
    return conformal_lengths(profile).sum() - wanted;
  };
  // The length falls with the gap, to nothing as it grows: first bounds, then halves between them,
  // of the logarithm.
  double low = x.maxCoeff(), high = low;
  while (excess(low) < 0) low /= 2;
  while (excess(high) > 0) high *= 2;
  while (high > low * (1 + 1e-14)) {
    const double gap = std::sqrt(low * high);
    (excess(gap) > 0 ? low : high) = gap;
  }
  return profile;
}

/// \ingroup PkgSurfaces
/// \brief the torus that a profile sweeps about the axis z, in faces near halves of one rectangle,
/// conformally.
/// \param profile counter-clockwise, if normals are to point outward; should be much finer than n
/// \param m, n how many vertices go around the axis, and around the tube
/// \throw Precondition_error if the profile is unsuitable, as for `conformal_lengths()`, or m or n
/// are below three
inline Mesh_view torus_of_revolution(const Profile& profile, int m, int n)
{
  const Profile p = evenly_spaced<2>(profile, conformal_lengths(profile), n);
  const double turn = 8 * std::atan(1.);
  return torus_grid(m, n, 0, [&](int i, int j) {
    const double u = turn * i / m;
    return Eigen::Vector3d(p(0, j) * std::cos(u), p(0, j) * std::sin(u), p(1, j));
  });
}

}  // namespace Conformal_geometry_processing

#endif
