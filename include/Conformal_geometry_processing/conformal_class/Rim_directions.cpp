// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Rim_directions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>

namespace Conformal_geometry_processing {

namespace internal {

/// The frame (T, N, B) of a face at its first edge, and the place of the third vertex in it
struct Rim_frame {
  Rim_frame(const Points& f, const std::array<int, 3>& face)
  {
    const Eigen::Vector3d e = f.col(face[1]) - f.col(face[0]), g = f.col(face[2]) - f.col(face[0]);
    length = e.norm();
    const Eigen::Vector3d T = e / length, N = e.cross(g).normalized(), B = T.cross(N);
    axes << T, N, B;
    foot = g.dot(T) / length;
    height = -g.dot(B);
  }

  Eigen::Matrix3d axes;  // in columns
  double length, foot;   // of the edge; the foot of the third vertex on it, by its length
  double height;         // of the third vertex above the edge
};

}  // namespace internal

internal::Rim_directions::Rim_directions(const Mesh_view& mesh, const Eigen::Vector3d& direction)
    : m_direction(direction.normalized())
{
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0)
      m_faces.push_back({mesh.from(h), mesh.to(h), mesh.to(Mesh_view::next_in_face(h))});
  m_normals.resize(3, static_cast<Eigen::Index>(m_faces.size()));
  m_others.resizeLike(m_normals);
  for (Eigen::Index k = 0; k < m_normals.cols(); ++k) {
    const Rim_frame frame(mesh.positions(), m_faces[static_cast<std::size_t>(k)]);
    const Eigen::Vector3d U = frame.axes * m_direction;
    m_normals.col(k) = U.unitOrthogonal();
    m_others.col(k) = U.cross(m_normals.col(k));
  }
}

Eigen::VectorXd internal::Rim_directions::residuals(const Points& f) const
{
  Eigen::VectorXd r(size_of_rows());
  for (Eigen::Index k = 0; k < m_normals.cols(); ++k) {
    const Rim_frame frame(f, m_faces[static_cast<std::size_t>(k)]);
    const Eigen::Vector3d U = frame.axes * m_direction;
    r[2 * k] = U.dot(m_normals.col(k));
    r[2 * k + 1] = U.dot(m_others.col(k));
  }
  return r;
}

// The frame turns about N and B as the edge does, by a_B and a_N over its length, and about T as
// the third vertex rises from the line of the edge, by w over its height:
// dU = t (a_N N + a_B B) + n (w B - a_N T) - b (w N + a_B T).
std::vector<internal::Rim_directions::Row> internal::Rim_directions::derivative(
    const Points& f) const
{
  std::vector<Row> rows;
  for (Eigen::Index k = 0; k < m_normals.cols(); ++k) {
    const std::array<int, 3>& face = m_faces[static_cast<std::size_t>(k)];
    const Rim_frame frame(f, face);
    const Eigen::Vector3d T = frame.axes.col(0), N = frame.axes.col(1), B = frame.axes.col(2);
    const double t = m_direction[0], n = m_direction[1], b = m_direction[2];
    for (const Eigen::Vector3d p : {m_normals.col(k), m_others.col(k)}) {
      const double of_a_N = t * N.dot(p) - n * T.dot(p), of_a_B = t * B.dot(p) - b * T.dot(p);
      const double of_w = n * B.dot(p) - b * N.dot(p);
      const Eigen::Vector3d turn = (of_a_N * N + of_a_B * B) / frame.length,
                            rise = of_w / frame.height * N;
      Row row{face, {}};
      row.gradients << -turn - (1 - frame.foot) * rise, turn - frame.foot * rise, rise;
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace Conformal_geometry_processing
