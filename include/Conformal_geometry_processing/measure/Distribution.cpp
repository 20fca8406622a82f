// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Distribution.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// the least value with at least a share of the weight at or below it; O(n)
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                         double share)
{
  std::vector<int> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), 0);
  const double wanted = share * weights.sum();
  double below = 0;  // the weight before `first`; the quantile is in [first, last)
  for (auto first = order.begin(), last = order.end();;) {
    if (last - first == 1) return values[*first];
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [&](int a, int b) { return values[a] < values[b]; });
    const double half =
        std::accumulate(first, middle, 0., [&](double sum, int i) { return sum + weights[i]; });
    if (below + half >= wanted) {
      last = middle;
    } else {
      below += half;
      first = middle;
    }
  }
}

}  // namespace internal

internal::Distribution distribution(const Eigen::VectorXd& values, const Eigen::VectorXd& weights)
{
  if (values.size() == 0) return {};
  return {values.dot(weights) / weights.sum(), internal::weighted_quantile(values, weights, 0.99),
          values.maxCoeff()};
}

Eigen::VectorXd histogram(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, int bins,
                          double low, double high)
{
  Eigen::VectorXd share = Eigen::VectorXd::Zero(bins);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double t = (values[i] - low) / (high - low) * bins;
    share[t > 0 ? static_cast<Eigen::Index>((std::min)(t, bins - 1.)) : 0] += weights[i];
  }
  return share / weights.sum();
}

}  // namespace Conformal_geometry_processing
