// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>
#include <cmath>

namespace Conformal_geometry_processing {

Eigen::Vector3d transformed_edge(const Eigen::Vector3d& e, const Quaternion<double>& l_i,
                                 const Quaternion<double>& l_j)
{
  // The two mixed terms are minus conjugates of each other: their sum is twice Im(mixed).
  const Quaternion<double> mixed = conjugate(l_i) * imaginary(e) * l_j;
  return (spin(l_i, e) + imaginary_part(mixed) + spin(l_j, e)) / 3;
}

Eigen::MatrixX3d transformed_edges(const Surface_ref& surface,
                                   const Quaternion_vector<double>& lambda)
{
  Eigen::MatrixX3d edges(surface.size_of_edges(), 3);
  internal::for_each_index(surface.size_of_edges(), 1024, [&](int k) {
    const auto [i, j] = surface.ends(k);
    const Eigen::Vector3d e = surface.position(j) - surface.position(i);
    edges.row(k) = transformed_edge(e, lambda[i], lambda[j]).transpose();
  });
  return edges;
}

double internal::closure_residual(const Surface_ref& surface, const Eigen::VectorXd& weights,
                                  const Points& f, const Eigen::MatrixX3d& edges)
{
  double difference = 0, total = 0;
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    const Eigen::Vector3d e = edges.row(k);
    const Eigen::Vector3d d = f.col(surface.ends(k)[1]) - f.col(surface.ends(k)[0]);
    difference += std::abs(weights[k]) * (d - e).squaredNorm();
    total += std::abs(weights[k]) * e.squaredNorm();
  }
  return std::sqrt(difference / total);
}

}  // namespace Conformal_geometry_processing
