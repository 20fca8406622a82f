// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_DISTRIBUTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_DISTRIBUTION_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief how a quantity is spread over a surface.
struct Distribution {
  double mean = 0;  ///< weighted
  double p99 = 0;   ///< 99 % of the weight lies at or below
  double max = 0;
};

/// \ingroup PkgMeasure
/// the distribution of values with positive weights, usually areas; O(n log n)
inline Distribution distribution(const Eigen::VectorXd& values, const Eigen::VectorXd& weights)
{
  if (values.size() == 0) return {};
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] < values[b]; });
  const double total = weights.sum();
  Distribution d;
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

/// \ingroup PkgMeasure
/// the share of the weight in each of `bins` intervals of equal width from `low` to `high`; values
/// outside count in the first or the last
inline Eigen::VectorXd histogram(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                 int bins, double low, double high)
{
  Eigen::VectorXd share = Eigen::VectorXd::Zero(bins);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double t = (values[i] - low) / (high - low) * bins;
    share[static_cast<Eigen::Index>(std::clamp(t, 0., bins - 1.))] += weights[i];
  }
  return share / weights.sum();
}

}  // namespace Conformal_geometry_processing

#endif
