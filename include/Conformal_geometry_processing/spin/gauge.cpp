// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/gauge.h>

#include <cmath>

namespace Conformal_geometry_processing {

void fix_gauge(Quaternion_vector<double>& lambda, const Eigen::VectorXd& areas,
               const internal::Surface_part& part)
{
  const double vanishing = 1e-6;  // relative to the root mean square
  const auto own = components(lambda).leftCols(part.own_vertices(lambda.size()));
  const Eigen::VectorXd shares = areas.head(own.cols()) / part.sum(areas.head(own.cols()).sum());
  const double length = std::sqrt(part.sum((own.colwise().squaredNorm() * shares).value()));
  Eigen::VectorXd direction = part.sum(own * shares);
  if (direction.norm() < vanishing * length) {
    Eigen::Index largest;
    const double square = own.colwise().squaredNorm().maxCoeff(&largest);
    const bool is_here = square == part.largest(Eigen::VectorXd::Constant(1, square));
    direction = part.sum(is_here ? Eigen::VectorXd(own.col(largest)) : Eigen::Vector4d::Zero());
  }
  direction /= direction.norm() * length;
  const Quaternion<double> q{direction[0], -direction[1], -direction[2], -direction[3]};
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
