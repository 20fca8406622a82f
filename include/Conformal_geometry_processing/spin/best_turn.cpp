// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/best_turn.h>

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Core>

#include <algorithm>

namespace Conformal_geometry_processing {

Quaternion<double> best_turn(const Points& U, const Points& V)
{
  const Quaternion<double> units[] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  Block<double> M = Block<double>::Zero(4, 4);  // of the mean of |U q - q V|^2, in [0, 4]
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    Quaternion<double> image[4];
    for (int c = 0; c < 4; ++c)
      image[c] = imaginary(U.col(k)) * units[c] - units[c] * imaginary(V.col(k));
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        M(r, c) += dot(image[r], image[c]) / static_cast<double>(U.cols());
  }
  const auto eigen = hermitian_eigen_decomposition<double>(M);
  const auto vector = [&](int c) -> Eigen::Vector4d { return eigen.vectors.col(c); };
  // If even the best rotation does not fit, those with up to three times its misfit count as
  // equally good: nearly parallel binormals of a hemisphere, to be tilted inward, do not require a
  // half turn.
  const double as_good = (std::max)(0.02, 2 * eigen.values[0]), nothing = 1e-3;
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  for (int c = 0; c < 4; ++c)
    if (eigen.values[c] <= eigen.values[0] + as_good) best += vector(c)[0] * vector(c);
  if (best.norm() < nothing) best = vector(0);
  best.normalize();
  return {best[0], best[1], best[2], best[3]};
}

}  // namespace Conformal_geometry_processing
