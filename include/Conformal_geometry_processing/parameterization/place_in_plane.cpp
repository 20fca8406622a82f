// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <vector>

namespace Conformal_geometry_processing {

Points in_space(const Eigen::VectorXcd& z)
{
  Points p = Points::Zero(3, z.size());
  p.row(0) = z.real().transpose();
  p.row(1) = z.imag().transpose();
  return p;
}

Eigen::VectorXcd place_in_plane(const Mesh_view& mesh, Eigen::VectorXcd z,
                                const std::vector<int>& loop)
{
  std::complex<double> mean = 0;
  for (const int v : loop) mean += z[v];
  z.array() -= mean / static_cast<double>(loop.size());
  double area = 0;
  for (const auto& v : mesh.corners())
    area += std::abs(std::imag(std::conj(z[v[1]] - z[v[0]]) * (z[v[2]] - z[v[0]]))) / 2;
  if (area > 0) z *= std::sqrt(face_areas(mesh).sum() / area);
  const std::complex<double> first = z[loop.front()];
  if (std::abs(first) > 0) z *= std::conj(first) / std::abs(first);
  return z;
}

}  // namespace Conformal_geometry_processing
