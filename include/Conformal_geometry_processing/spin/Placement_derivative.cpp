// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Placement_derivative.h>

#include <Conformal_geometry_processing/algebra/stable_norm.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <utility>

namespace Conformal_geometry_processing::internal {

/// calls use(face, c, vertex, gradient of the face's area with respect to the vertex)
template <class Use>
void for_each_area_gradient(const Mesh_view& mesh, const Points& f, const Points& normals, Use use)
{
  for (int i = 0; i < mesh.size_of_faces(); ++i) {
    const auto& v = mesh.corners(i);
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d opposite = f.col(v[(c + 2) % 3]) - f.col(v[(c + 1) % 3]);
      use(i, v[c], Eigen::Vector3d(normals.col(i).cross(opposite) / 2));
    }
  }
}

Placement_derivative::Placement_derivative(const Mesh_view& mesh, Points f)
    : m_mesh(mesh),
      m_arms(std::move(f)),
      m_area_gradient(Points::Zero(3, m_arms.cols())),
      m_areas(mesh.size_of_faces()),
      m_middle(3, mesh.size_of_faces()),
      m_normals(3, mesh.size_of_faces())
{
  for (int i = 0; i < mesh.size_of_faces(); ++i) {
    const auto& v = mesh.corners(i);
    const Eigen::Vector3d twice = mesh.double_area_vector(i, m_arms);
    m_areas[i] = twice.norm() / 2;
    m_normals.col(i) = stable_normalized(twice);
    m_middle.col(i) = (m_arms.col(v[0]) + m_arms.col(v[1]) + m_arms.col(v[2])) / 3;
  }
  const Eigen::Vector3d centroid = m_middle * m_areas / m_areas.sum();
  m_middle.colwise() -= centroid;
  m_arms.colwise() -= centroid;
  for_each_area_gradient(mesh, m_arms, m_normals, [this](int, int v, const Eigen::Vector3d& g) {
    m_area_gradient.col(v) += g;
  });
}

Points Placement_derivative::apply(const Points& df) const
{
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for_each_area_gradient(m_mesh, m_arms, m_normals, [&](int i, int v, const Eigen::Vector3d& g) {
    moment += g.dot(df.col(v)) * m_middle.col(i) + m_areas[i] / 3 * df.col(v);
  });
  const double growth = m_area_gradient.cwiseProduct(df).sum() / (2 * m_areas.sum());
  return (df - growth * m_arms).colwise() - moment / m_areas.sum();
}

Points Placement_derivative::apply_transpose(const Points& y) const
{
  const double area = m_areas.sum(), growth = y.cwiseProduct(m_arms).sum() / (2 * area);
  const Eigen::Vector3d force = y.rowwise().sum() / area;
  Points result = y - growth * m_area_gradient;
  for_each_area_gradient(m_mesh, m_arms, m_normals, [&](int i, int v, const Eigen::Vector3d& g) {
    result.col(v) -= m_middle.col(i).dot(force) * g + m_areas[i] / 3 * force;
  });
  return result;
}

}  // namespace Conformal_geometry_processing::internal
