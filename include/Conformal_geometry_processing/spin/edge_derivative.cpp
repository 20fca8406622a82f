// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/edge_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

// e~ = (l_i^ e l_i + Im(l_i^ e l_j) + l_j^ e l_j) / 3 with l^ = conjugate(l). The changes of the
// outer terms are 2 Im(l^ e dl).
Eigen::MatrixX3d edge_change(const Surface_ref& surface, const Quaternion_vector<double>& lambda,
                             const Quaternion_vector<double>& dlambda)
{
  Eigen::MatrixX3d change(surface.size_of_edges(), 3);
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    const auto [i, j] = surface.ends(k);
    const Quaternion<double> e =
        imaginary(Eigen::Vector3d(surface.position(j) - surface.position(i)));
    const Quaternion<double> at_i = conjugate(2. * lambda[i] + lambda[j]) * e * dlambda[i];
    const Quaternion<double> at_j = conjugate(lambda[i] + 2. * lambda[j]) * e * dlambda[j];
    change.row(k) = imaginary_part(at_i + at_j).transpose() / 3;
  }
  return change;
}

// <y, Im(a^ e dl)> = Re(conjugate(-e a y) dl) for imaginary e and y.
Quaternion_vector<double> edge_gradient(const Surface_ref& surface,
                                        const Quaternion_vector<double>& lambda,
                                        const Eigen::MatrixX3d& y)
{
  Quaternion_vector<double> q = Quaternion_vector<double>::Constant(lambda.size(), {});
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    const auto [i, j] = surface.ends(k);
    const Eigen::Vector3d e = (surface.position(j) - surface.position(i)) / -3;
    const Quaternion<double> y_k = imaginary(Eigen::Vector3d(y.row(k)));
    q[i] += imaginary(e) * (2. * lambda[i] + lambda[j]) * y_k;
    q[j] += imaginary(e) * (lambda[i] + 2. * lambda[j]) * y_k;
  }
  return q;
}

}  // namespace Conformal_geometry_processing::internal
