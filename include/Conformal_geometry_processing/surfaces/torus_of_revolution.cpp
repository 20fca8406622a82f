// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/torus_of_revolution.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/surfaces/evenly_spaced.h>
#include <Conformal_geometry_processing/surfaces/torus_grid.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {
namespace internal {

void require_profile(const Profile& profile, const std::string& function)
{
  if (profile.cols() < 3 || !profile.allFinite() || !(profile.row(0).array() > 0).all())
    throw Precondition_error(function,
                             "the profile has " + std::to_string(profile.cols()) +
                                 " points; wanted three at least, all of them finite and at "
                                 "positive distances from the axis");
}

}  // namespace internal

Eigen::VectorXd conformal_lengths(const internal::Profile& profile)
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

internal::Profile profile_of_class(internal::Profile profile, double b)
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
  // The length decreases to zero as the distance increases: finds bounds, then bisects the
  // logarithm of the distance.
  double low = x.maxCoeff(), high = low;
  while (excess(low) < 0) low /= 2;
  while (excess(high) > 0) high *= 2;
  while (high > low * (1 + 1e-14)) {
    const double gap = std::sqrt(low * high);
    (excess(gap) > 0 ? low : high) = gap;
  }
  return profile;
}

Mesh_view torus_of_revolution(const internal::Profile& profile, int m, int n)
{
  const internal::Profile p = evenly_spaced<2>(profile, conformal_lengths(profile), n);
  const double turn = 8 * std::atan(1.);
  return torus_grid(m, n, 0, [&](int i, int j) {
    const double u = turn * i / m;
    return Eigen::Vector3d(p(0, j) * std::cos(u), p(0, j) * std::sin(u), p(1, j));
  });
}

}  // namespace Conformal_geometry_processing
