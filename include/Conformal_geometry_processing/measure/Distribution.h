// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgMeasure
/// \brief Statistics of a quantity on a surface.
struct Distribution {
  double mean = 0;  ///< weighted
  double p99 = 0;   ///< 99 % of the weight lies at or below
  double max = 0;
};

}  // namespace internal

/// \ingroup PkgMeasure
/// Returns statistics of values with positive weights, usually areas; O(n)
internal::Distribution distribution(const Eigen::VectorXd& values, const Eigen::VectorXd& weights);

/// \ingroup PkgMeasure
/// Returns the share of the weight in each of `bins` intervals of equal width from `low` to `high`;
/// values outside are assigned to the first or the last one, NaN to the first
Eigen::VectorXd histogram(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, int bins,
                          double low, double high);

}  // namespace Conformal_geometry_processing
