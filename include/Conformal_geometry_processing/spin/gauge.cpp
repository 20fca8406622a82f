// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/gauge.h>

#include <cmath>

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

/// the area of positions f, and their integral
Eigen::Vector4d area_and_moment(const Mesh_view& mesh, const Points& f, const Surface_part& part)
{
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();
  for (int i = 0; i < part.own_faces(mesh.size_of_faces()); ++i) {
    const double area = mesh.double_area_vector(i, f).norm() / 2;
    sums[3] += area;
    for (int v : mesh.corners(i)) sums.head<3>() += area / 3 * f.col(v);
  }
  return part.sum(sums);
}

}  // namespace internal

void restore_area(const Mesh_view& mesh, Points& f, Quaternion_vector<double>& lambda,
                  const internal::Surface_part& part)
{
  const Eigen::Vector4d before = internal::area_and_moment(mesh, mesh.positions(), part),
                        after = internal::area_and_moment(mesh, f, part);
  const double scale = std::sqrt(before[3] / after[3]);
  f *= scale;
  components(lambda) *= std::sqrt(scale);
  f.colwise() += before.head<3>() / before[3] - scale * after.head<3>() / after[3];
}

}  // namespace Conformal_geometry_processing
