// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/laplacians.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Eigen::VectorXd laplacian(const internal::Surface_derivative& d, const Eigen::VectorXd& phi)
{
  return d.real_part(d.adjoint(d(phi)));
}

Points vector_laplacian(const internal::Surface_derivative& d, const Points& X,
                        const Points& normals)
{
  Quaternion_vector<double> q = d(X);
  components(q).bottomRows<3>() -= d.tangential_part(q);
  const Quaternion_vector<double> p = d.adjoint(q);
  const Points image = components(p).bottomRows<3>();
  const Eigen::VectorXd along = image.cwiseProduct(normals).colwise().sum().transpose();
  return image - normals * along.asDiagonal();
}

}  // namespace Conformal_geometry_processing
