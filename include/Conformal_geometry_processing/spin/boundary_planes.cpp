// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/boundary_planes.h>

#include <Conformal_geometry_processing/algebra/rotor.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

internal::Reduced_basis<double>::Plane boundary_plane(const Eigen::Vector3d& U,
                                                      const Eigen::Vector3d& V,
                                                      const Eigen::Vector3d& axis)
{
  const double almost_antipodal = 1e-8;
  Quaternion<double> q = rotor(U, V);
  if ((U + V).norm() < almost_antipodal) q = imaginary((axis - axis.dot(U) * U).normalized());
  return {q, -(q * imaginary(V))};
}

std::vector<char> make_continuous(const std::vector<std::vector<int>>& loops,
                                  std::vector<Quaternion<double>>& values)
{
  std::vector<char> closes;
  std::size_t first = 0;
  for (const std::vector<int>& loop : loops) {
    const std::size_t end = first + loop.size();
    double sum = values[first].w;
    for (std::size_t k = first + 1; k < end; ++k) {
      if (dot(values[k], values[k - 1]) < 0) values[k] *= -1;
      sum += values[k].w;
    }
    closes.push_back(dot(values[end - 1], values[first]) >= 0);
    if (sum < 0)
      for (std::size_t k = first; k < end; ++k) values[k] *= -1;
    first = end;
  }
  return closes;
}

Quaternion<double> boundary_spin(const internal::Boundary_frame& source,
                                 const internal::Boundary_frame& target, double ratio)
{
  return spin_of(Eigen::Matrix3d(target * source.transpose()), ratio);
}

}  // namespace Conformal_geometry_processing
