// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_TRANSFORMED_EDGES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_TRANSFORMED_EDGES_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>
#include <Conformal_geometry_processing/threads/parallel_loops.h>

#include <Eigen/Core>
#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::Vector3d transformed_edge(const Eigen::Vector3d& e, const Quaternion<double>& l_i,
                                            const Quaternion<double>& l_j)
{
  // The two mixed terms are minus conjugates of each other: their sum is twice Im(mixed).
  const Quaternion<double> mixed = conjugate(l_i) * imaginary(e) * l_j;
  return (spin(l_i, e) + imaginary_part(mixed) + spin(l_j, e)) / 3;
}

CGP_INLINE Eigen::MatrixX3d transformed_edges(const Surface_ref& surface,
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

CGP_INLINE double internal::closure_residual(const Surface_ref& surface,
                                             const Eigen::VectorXd& weights, const Points& f,
                                             const Eigen::MatrixX3d& edges)
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

#endif
