// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Moebius_map.h>

namespace Conformal_geometry_processing {

Moebius_map::Moebius_map(const Quaternion& a, const Quaternion& b, const Quaternion& c,
                         const Quaternion& d)
    : m_a(a), m_b(b), m_c(c), m_d(d)
{
  const Quaternion s = conjugate(a) * d + conjugate(c) * b;
  const double size = norm(a) * norm(d) + norm(b) * norm(c), zero = 1e-10;
  const bool is_moebius = s.w > zero * size && norm(imaginary(imaginary_part(s))) <= zero * size &&
                          std::abs(dot(a, c)) <= zero * norm(a) * norm(c) &&
                          std::abs(dot(b, d)) <= zero * norm(b) * norm(d);
  if (!is_moebius)
    throw Precondition_error("Moebius_map",
                             "the matrix does not map R^3 to itself with its orientation");
  for (Quaternion* q : {&m_a, &m_b, &m_c, &m_d}) *q *= 1 / std::sqrt(s.w);
}

Moebius_map Moebius_map::translation(const Eigen::Vector3d& t)
{
  return {one, imaginary(t), {}, one, Unchecked()};
}

Moebius_map Moebius_map::rotation(const Quaternion& q)
{
  return {conjugate(q), {}, {}, Conformal_geometry_processing::inverse(q), Unchecked()};
}

Moebius_map Moebius_map::sphere_inversion(const Eigen::Vector3d& c)
{
  return {one, {}, -imaginary(c), one, Unchecked()};
}

Moebius_map Moebius_map::inverse() const
{
  return {conjugate(m_d), conjugate(m_b), conjugate(m_c), conjugate(m_a), Unchecked()};
}

Eigen::Vector3d Moebius_map::operator()(const Eigen::Vector3d& point) const
{
  return image(point, spin(point));
}

Moebius_map::Quaternion Moebius_map::spin(const Eigen::Vector3d& point) const
{
  const Quaternion q = m_c * imaginary(point) + m_d;
  if (is_zero(q, point))
    throw Precondition_error("Moebius_map", "the point goes to infinity or is not finite");
  return Conformal_geometry_processing::inverse(q);
}

Eigen::Matrix3Xd Moebius_map::transform(Eigen::Matrix3Xd points, const std::string& function) const
{
  const Quaternion_vector<double> lambda = spins(points, function);
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = image(points.col(i), lambda[i]);
  return points;
}

Quaternion_vector<double> Moebius_map::spins(const Eigen::Matrix3Xd& points,
                                             const std::string& function) const
{
  Quaternion_vector<double> lambda(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Quaternion q = m_c * imaginary(points.col(i)) + m_d;
    if (is_zero(q, points.col(i)))
      throw Precondition_error(function, "point " + std::to_string(i) +
                                             " goes to infinity or is not finite; the map must "
                                             "send no point there");
    lambda[i] = Conformal_geometry_processing::inverse(q);
  }
  return lambda;
}

Moebius_map::Moebius_map(const Quaternion& a, const Quaternion& b, const Quaternion& c,
                         const Quaternion& d, Unchecked)
    : m_a(a), m_b(b), m_c(c), m_d(d)
{}

Eigen::Vector3d Moebius_map::image(const Eigen::Vector3d& point, const Quaternion& lambda) const
{
  return imaginary_part((m_a * imaginary(point) + m_b) * lambda);
}

// Returns whether c f + d is zero up to cancellation, or not finite.
bool Moebius_map::is_zero(const Quaternion& q, const Eigen::Vector3d& point) const
{
  const double terms = norm(m_c) * point.norm() + norm(m_d);
  return !(norm(q) > 1e-10 * terms);
}

}  // namespace Conformal_geometry_processing
