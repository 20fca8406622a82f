// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <complex>

#include "support/bounded_meshes.h"

/// Maps to the plane, and the matrices of their energies by the definitions.
namespace cgp_test {

/// x + i y of the points
inline Eigen::VectorXcd plane_points(const Mesh_view& mesh)
{
  Eigen::VectorXcd z(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    z[v] = {mesh.position(v).x(), mesh.position(v).y()};
  return z;
}

/// a_0, b_0, a_1, b_1, ... of a + i b
inline Eigen::VectorXd interleaved_parts(const Eigen::VectorXcd& z)
{
  Eigen::VectorXd ab(2 * z.size());
  for (Eigen::Index v = 0; v < z.size(); ++v) ab.segment<2>(2 * v) << z[v].real(), z[v].imag();
  return ab;
}

/// \brief the rows of least squares conformal maps: for each face the two components of
/// sqrt(area) (J grad a - grad b) in coordinates of its plane; 2|F| x 2|V|.
inline Eigen::MatrixXd least_squares_conformal_rows(const Mesh_view& mesh)
{
  Eigen::MatrixXd rows =
      Eigen::MatrixXd::Zero(2 * mesh.size_of_faces(), 2 * mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const Eigen::Vector3d p = mesh.position(v[1]) - mesh.position(v[0]),
                          q = mesh.position(v[2]) - mesh.position(v[0]);
    const double x1 = p.norm(), x2 = q.dot(p) / x1, y2 = p.cross(q).norm() / x1;
    Eigen::Matrix<double, 2, 3> gradient;  // of the hat functions of (0, 0), (x1, 0), (x2, y2)
    gradient << -1 / x1, 1 / x1, 0, (x2 - x1) / (x1 * y2), -x2 / (x1 * y2), 1 / y2;
    gradient *= std::sqrt(x1 * y2 / 2);
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector2d g = gradient.col(c);
      rows.block<2, 1>(2 * f, 2 * v[at(c)]) += Eigen::Vector2d(-g.y(), g.x());
      rows.block<2, 1>(2 * f, 2 * v[at(c)] + 1) -= g;
    }
  }
  return rows;
}

}  // namespace cgp_test
