// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_DISTRIBUTION_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_DISTRIBUTION_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/Distribution.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

CGP_INLINE internal::Distribution distribution(const Eigen::VectorXd& values,
                                               const Eigen::VectorXd& weights)
{
  if (values.size() == 0) return {};
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] < values[b]; });
  const double total = weights.sum();
  internal::Distribution d;
  d.mean = values.dot(weights) / total;
  d.max = values[order.back()];
  double below = 0;
  for (Eigen::Index i : order) {
    below += weights[i];
    d.p99 = values[i];
    if (below >= 0.99 * total) break;
  }
  return d;
}

CGP_INLINE Eigen::VectorXd histogram(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                     int bins, double low, double high)
{
  Eigen::VectorXd share = Eigen::VectorXd::Zero(bins);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double t = (values[i] - low) / (high - low) * bins;
    share[t > 0 ? static_cast<Eigen::Index>((std::min)(t, bins - 1.)) : 0] += weights[i];
  }
  return share / weights.sum();
}

}  // namespace Conformal_geometry_processing

#endif
