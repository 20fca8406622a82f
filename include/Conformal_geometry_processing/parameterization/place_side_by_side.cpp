// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/place_side_by_side.h>

#include <Conformal_geometry_processing/parameterization/pack_in_rows.h>

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

void place_side_by_side(const std::vector<int>& component, Eigen::VectorXcd& z)
{
  if (component.empty()) return;
  const auto of = [&](Eigen::Index v) { return component[static_cast<std::size_t>(v)]; };
  const int count = 1 + *std::max_element(component.begin(), component.end());
  Eigen::Matrix2Xd low = Eigen::Matrix2Xd::Constant(2, count, HUGE_VAL), high = -low;
  for (Eigen::Index v = 0; v < z.size(); ++v) {
    const Eigen::Vector2d p(z[v].real(), z[v].imag());
    low.col(of(v)) = low.col(of(v)).cwiseMin(p);
    high.col(of(v)) = high.col(of(v)).cwiseMax(p);
  }
  const Eigen::Matrix2Xd sizes = high - low;
  const Eigen::Matrix2Xd moves = pack_in_rows(sizes, 0.01 * sizes.maxCoeff()) - low;
  for (Eigen::Index v = 0; v < z.size(); ++v)
    z[v] += std::complex<double>(moves(0, of(v)), moves(1, of(v)));
}

}  // namespace Conformal_geometry_processing
