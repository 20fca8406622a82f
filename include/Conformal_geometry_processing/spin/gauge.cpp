// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/gauge.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>
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

}  // namespace Conformal_geometry_processing
