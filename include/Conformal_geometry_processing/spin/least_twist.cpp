// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/least_twist.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// the unit quaternion at an angle in a plane
Quaternion<double> at_angle(const Boundary_plane& plane, double angle)
{
  return plane[0] * std::cos(angle) + plane[1] * std::sin(angle);
}

/// the angle that maps coordinates in one plane to those of the nearest points of another, averaged
/// over all points: a rotation, so that its sum over a loop does not depend on the start
double turn_between(const Boundary_plane& from, const Boundary_plane& to)
{
  const double cosine = dot(to[0], from[0]) + dot(to[1], from[1]);
  const double sine = dot(to[1], from[0]) - dot(to[0], from[1]);
  return std::atan2(sine, cosine);
}

/// the angle by which quaternions, one in each plane, have to turn to be nearest to q on the whole
double angle_to_nearest(const std::vector<Boundary_plane>& planes,
                        const std::vector<double>& angles, const Quaternion<double>& q)
{
  const double quarter = 1.57079632679489661923, nothing = 1e-6;
  double u = 0, v = 0;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    u += dot(at_angle(planes[k], angles[k]), q);
    v += dot(at_angle(planes[k], angles[k] + quarter), q);
  }
  return std::hypot(u, v) > nothing * static_cast<double>(planes.size()) ? std::atan2(v, u) : 0;
}

}  // namespace internal

std::vector<Quaternion<double>> least_twist(
    const std::vector<internal::Reduced_basis<double>::Plane>& planes, const Quaternion<double>& q)
{
  const std::size_t n = planes.size();
  std::vector<double> angles;
  double angle = 0;
  for (std::size_t k = 0; k < n; ++k) {
    angles.push_back(angle);
    angle += internal::turn_between(planes[k], planes[(k + 1) % n]);
  }
  const double missing = -std::remainder(angle, 2 * std::acos(-1.));
  for (std::size_t k = 0; k < n; ++k)
    angles[k] += missing * static_cast<double>(k) / static_cast<double>(n);
  const double turn = internal::angle_to_nearest(planes, angles, q);
  std::vector<Quaternion<double>> section;
  for (std::size_t k = 0; k < n; ++k)
    section.push_back(internal::at_angle(planes[k], angles[k] + turn));
  return section;
}

}  // namespace Conformal_geometry_processing
