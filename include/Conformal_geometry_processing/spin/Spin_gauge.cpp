// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_gauge.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

void fix_gauge(Quaternion_vector<double>& lambda, const Eigen::VectorXd& areas)
{
  const double vanishing = 1e-6;  // relative to the root mean square
  const Eigen::VectorXd shares = areas / areas.sum();
  Quaternion<double> direction;
  double square = 0;
  for (Eigen::Index i = 0; i < lambda.size(); ++i) {
    direction += shares[i] * lambda[i];
    square += shares[i] * squared_norm(lambda[i]);
  }
  const double length = std::sqrt(square);
  if (norm(direction) < vanishing * length) {
    Eigen::Index largest;
    components(lambda).colwise().squaredNorm().maxCoeff(&largest);
    direction = lambda[largest];
  }
  const Quaternion<double> q = conjugate(direction) / (norm(direction) * length);
  for (Eigen::Index i = 0; i < lambda.size(); ++i) lambda[i] = lambda[i] * q;
}

namespace internal {

Eigen::Vector3d centroid(const Mesh_view& mesh, const Points& f, const Eigen::VectorXd& areas)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < mesh.size_of_faces(); ++i)
    for (int v : mesh.corners(i)) sum += areas[i] / 3 * f.col(v);
  return sum / areas.sum();
}

}  // namespace internal

void restore_area(const Mesh_view& mesh, Points& f, Quaternion_vector<double>& lambda)
{
  const Eigen::VectorXd areas = face_areas(mesh);
  Eigen::VectorXd new_areas(areas.size());
  for (int i = 0; i < mesh.size_of_faces(); ++i)
    new_areas[i] = mesh.double_area_vector(i, f).norm() / 2;
  const double scale = std::sqrt(areas.sum() / new_areas.sum());
  f *= scale;
  components(lambda) *= std::sqrt(scale);
  f.colwise() +=
      internal::centroid(mesh, mesh.positions(), areas) - internal::centroid(mesh, f, new_areas);
}

namespace internal {

auto Spin_gauge::normalized(Spins lambda) const -> Spins
{
  if (!m_is_free)
    components(lambda) *= std::sqrt(m_system.areas().sum() / m_system.squared_norm(lambda));
  return lambda;
}

auto Spin_gauge::projected(const Spins& lambda, Spins y) const -> Spins
{
  if (m_is_free) return y;
  y = m_system.projected(std::move(y)).col(0);
  const Quaternion<double> q =
      reduced_to(m_system.coefficients(), inner_product(lambda, m_system.areas(), y)) *
      (-1 / m_system.squared_norm(lambda));
  add_multiple(y, lambda, q);
  return y;
}

auto Spin_gauge::projected_gradient(const Spins& lambda, Spins g) const -> Spins
{
  if (m_is_free) return g;
  g = m_system.projected(std::move(g)).col(0);
  const Quaternion<double> q = reduced_to(m_system.coefficients(), inner_product(lambda, g)) *
                               (-1 / m_system.squared_norm(lambda));
  for (Eigen::Index v = 0; v < g.size(); ++v) g[v] += m_system.areas()[v] * (lambda[v] * q);
  return g;
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
