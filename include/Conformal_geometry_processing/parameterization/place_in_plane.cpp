// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>

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

Eigen::Matrix2Xd pack_in_rows(const Eigen::Matrix2Xd& sizes, double gap)
{
  std::vector<Eigen::Index> order(static_cast<std::size_t>(sizes.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return sizes(1, a) > sizes(1, b); });
  const double area = ((sizes.row(0).array() + gap) * (sizes.row(1).array() + gap)).sum();
  Eigen::Matrix2Xd corners(2, sizes.cols());
  double x = 0, y = 0, height = 0;
  for (const Eigen::Index i : order) {
    if (x > 0 && x + sizes(0, i) / 2 > std::sqrt(area)) {
      x = 0;
      y += height + gap;
    }
    if (x == 0) height = sizes(1, i);  // the highest in its row
    corners.col(i) << x, y;
    x += sizes(0, i) + gap;
  }
  return corners;
}

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
