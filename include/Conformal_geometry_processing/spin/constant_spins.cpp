// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/constant_spins.h>

#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Vector<Quaternion<double>> constant_spins(const internal::Reduced_basis<double>& basis)
{
  const int n = basis.rows().size();
  Block<Quaternion<double>> units(n, 4);
  for (int i = 0; i < n; ++i)
    units.row(i) << Quaternion<double>{1, 0, 0, 0}, Quaternion<double>{0, 1, 0, 0},
        Quaternion<double>{0, 0, 1, 0}, Quaternion<double>{0, 0, 0, 1};
  const Block<Quaternion<double>> rest = units - basis.project(units);
  Block<double> defect = Block<double>::Zero(4, 4);
  for (int i = 0; i < n; ++i)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) defect(a, b) += dot(rest(i, a), rest(i, b));
  const auto eigen = hermitian_eigen_decomposition(defect);
  const double rounding = 1e-20 * n;
  const Eigen::Index count = (eigen.values.array() <= rounding).count();
  Vector<Quaternion<double>> spins(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector4d q = eigen.vectors.col(k);
    spins[k] = {q[0], q[1], q[2], q[3]};
  }
  return spins;
}

}  // namespace Conformal_geometry_processing
