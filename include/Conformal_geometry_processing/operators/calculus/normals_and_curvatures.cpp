// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/normals_and_curvatures.h>

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Points dirac_normals(const internal::Surface_derivative& d)
{
  return -components(d(d.mesh().positions())).bottomRows<3>() / 2;
}

Eigen::VectorXd dirac_mean_curvature(const internal::Surface_derivative& d, const Points& normals)
{
  return -d.normal_part(d(normals)) / 2;
}

Eigen::VectorXd dirac_gauss_curvature(const internal::Surface_derivative& d, const Points& normals)
{
  const auto X = dirac_energy(d.mesh(), no_potential(d.mesh()));
  const Eigen::VectorXd areas = vertex_areas(d.mesh());
  Quaternion_vector<double> image(areas.size());
  X.for_each_entry([&](int i, int j, Quaternion<double> x) {
    x.w = 0;
    image[i] += x * imaginary(normals.col(j));
    if (i != j) image[j] += conjugate(x) * imaginary(normals.col(i));
  });
  Eigen::VectorXd K(areas.size());
  for (Eigen::Index v = 0; v < K.size(); ++v)
    K[v] = normals.col(v).dot(imaginary_part(image[v])) / (2 * areas[v]);
  return K;
}

}  // namespace Conformal_geometry_processing
