// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Counted_faces.h"

#include <cmath>

namespace conformal::mpi {

double overlap(const Distributed_mesh& mesh, const Eigen::VectorXd& areas,
               const CGP::Quaternion_vector<double>& a, const CGP::Quaternion_vector<double>& b)
{
  Eigen::Vector4d product = Eigen::Vector4d::Zero();
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  for (int v = 0; v < mesh.own_vertices(); ++v) {
    const CGP::Quaternion<double> q = CGP::conjugate(a[v]) * b[v];
    product += areas[v] * Eigen::Vector4d(q.w, q.x, q.y, q.z);
    squares += areas[v] * Eigen::Vector2d(CGP::squared_norm(a[v]), CGP::squared_norm(b[v]));
  }
  return sum_of(product).norm() / std::sqrt(sum_of(squares).prod());
}

}  // namespace conformal::mpi
