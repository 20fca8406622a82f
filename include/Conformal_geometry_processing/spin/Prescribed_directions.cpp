// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Prescribed_directions.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/best_turn.h>
#include <Conformal_geometry_processing/spin/boundary_planes.h>
#include <Conformal_geometry_processing/spin/least_twist.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

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
