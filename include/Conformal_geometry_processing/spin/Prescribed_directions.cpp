// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Prescribed_directions.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/algebra/rotor.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

Quaternion<double> best_turn(const Points& U, const Points& V)
{
  const Quaternion<double> units[] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  Block<double> M = Block<double>::Zero(4, 4);  // of the mean of |U q - q V|^2, in [0, 4]
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    Quaternion<double> image[4];
    for (int c = 0; c < 4; ++c)
      image[c] = imaginary(U.col(k)) * units[c] - units[c] * imaginary(V.col(k));
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        M(r, c) += dot(image[r], image[c]) / static_cast<double>(U.cols());
  }
  const auto eigen = hermitian_eigen_decomposition<double>(M);
  const auto vector = [&](int c) -> Eigen::Vector4d { return eigen.vectors.col(c); };
  // If even the best rotation does not fit, those with up to three times its misfit count as
  // equally good: nearly parallel binormals of a hemisphere, to be tilted inward, do not require a
  // half turn.
  const double as_good = (std::max)(0.02, 2 * eigen.values[0]), nothing = 1e-3;
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  for (int c = 0; c < 4; ++c)
    if (eigen.values[c] <= eigen.values[0] + as_good) best += vector(c)[0] * vector(c);
  if (best.norm() < nothing) best = vector(0);
  best.normalize();
  return {best[0], best[1], best[2], best[3]};
}

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

internal::Reduced_basis<double>::Plane boundary_plane(const Eigen::Vector3d& U,
                                                      const Eigen::Vector3d& V,
                                                      const Eigen::Vector3d& axis)
{
  const double almost_antipodal = 1e-8;
  Quaternion<double> q = rotor(U, V);
  if ((U + V).norm() < almost_antipodal) q = imaginary((axis - axis.dot(U) * U).normalized());
  return {q, -(q * imaginary(V))};
}

std::vector<char> make_continuous(const std::vector<std::vector<int>>& loops,
                                  std::vector<Quaternion<double>>& values)
{
  std::vector<char> closes;
  std::size_t first = 0;
  for (const std::vector<int>& loop : loops) {
    const std::size_t end = first + loop.size();
    double sum = values[first].w;
    for (std::size_t k = first + 1; k < end; ++k) {
      if (dot(values[k], values[k - 1]) < 0) values[k] *= -1;
      sum += values[k].w;
    }
    closes.push_back(dot(values[end - 1], values[first]) >= 0);
    if (sum < 0)
      for (std::size_t k = first; k < end; ++k) values[k] *= -1;
    first = end;
  }
  return closes;
}

Quaternion<double> boundary_spin(const internal::Boundary_frame& source,
                                 const internal::Boundary_frame& target, double ratio)
{
  return spin_of(Eigen::Matrix3d(target * source.transpose()), ratio);
}

void internal::Prescribed_directions::update_geometry()
{
  m_frames = boundary_frames(m_surface);
  update();
}

Eigen::VectorXd internal::Prescribed_directions::errors(const Surface_ref& surface,
                                                        const Points& targets) const
{
  const internal::Boundary_frames frames = boundary_frames(surface);
  Eigen::VectorXd angles(targets.cols());
  for (Eigen::Index k = 0; k < angles.size(); ++k) {
    const Eigen::Vector3d U = frames.frames[static_cast<std::size_t>(k)] * m_coefficients;
    const Eigen::Vector3d V = targets.col(k);
    angles[k] = std::atan2(U.cross(V).norm(), U.dot(V));
  }
  return angles;
}

Points internal::Prescribed_directions::normalized(Points v)
{
  for (Eigen::Index k = 0; k < v.cols(); ++k) v.col(k) = stable_normalized(v.col(k));
  return v;
}

Points internal::Prescribed_directions::sources() const
{
  Points U(3, static_cast<Eigen::Index>(m_frames.frames.size()));
  for (std::size_t k = 0; k < m_frames.frames.size(); ++k)
    U.col(static_cast<Eigen::Index>(k)) = m_frames.frames[k] * m_coefficients;
  return U;
}

void internal::Prescribed_directions::update()
{
  const Points U = sources();
  if (!m_has_targets) m_targets = U;
  std::vector<internal::Reduced_basis<double>::Plane> planes;
  const Quaternion<double> turn = best_turn(U, m_targets);
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    const Eigen::Vector3d N = m_frames.normal(static_cast<std::size_t>(k));
    const internal::Reduced_basis<double>::Plane rest =
        boundary_plane(spin(turn, U.col(k)), m_targets.col(k), spin(turn, N));
    planes.push_back({turn * rest[0], turn * rest[1]});
  }
  std::vector<Quaternion<double>> rotors;
  auto first = planes.begin();
  for (const std::vector<int>& loop : m_frames.loops) {
    const auto end = first + static_cast<std::ptrdiff_t>(loop.size());
    const auto section = least_twist({first, end}, turn);
    rotors.insert(rotors.end(), section.begin(), section.end());
    first = end;
  }
  m_basis = Reduced_basis<double>(m_surface.size_of_vertices(), m_frames.vertices, planes);
  m_guide = m_basis.project(harmonic_extension(rotors)).col(0);
}

Block<Quaternion<double>> internal::Prescribed_directions::harmonic_extension(
    const std::vector<Quaternion<double>>& rotors)
{
  const Eigen::Index n = m_surface.size_of_vertices();
  Block<double> values = Block<double>::Zero(n, 4);
  for (std::size_t k = 0; k < rotors.size(); ++k)
    values.row(m_frames.vertices[k]) << rotors[k].w, rotors[k].x, rotors[k].y, rotors[k].z;
  assemble_cotan_laplacian(m_surface, cotan_weights(m_surface), m_L);
  m_harmonic.factorize(m_L);
  const Block<double> q = m_harmonic.solve(m_L, Block<double>::Zero(n, 4), values);
  Block<Quaternion<double>> extension(n, 1);
  for (Eigen::Index i = 0; i < n; ++i) extension(i, 0) = {q(i, 0), q(i, 1), q(i, 2), q(i, 3)};
  return extension;
}

}  // namespace Conformal_geometry_processing
