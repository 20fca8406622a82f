// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spectral_pairs.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Conformal_geometry_processing {

double internal::squared_error(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  const Eigen::Index n = (std::min)(count, pairs.size());
  const auto errors = pairs.energies.head(n).array() - pairs.quotients.head(n).array().square();
  return n == 0 ? 0. : (std::max)(errors.maxCoeff(), 0.);
}

double internal::needed_reach(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  const double last = pairs.quotients[count - 1];
  return last * last + 2 * squared_error(pairs, count);
}

double internal::complete_radius(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  Eigen::Index sure = 0;
  while (sure < (std::min)(count, pairs.size()) && is_window_complete(pairs, sure + 1)) ++sure;
  if (sure == 0) return 0;
  const double radius = std::sqrt(pairs.reach - 2 * squared_error(pairs, sure));
  return sure < pairs.size() ? (std::min)(radius, std::abs(pairs.quotients[sure])) : radius;
}

bool internal::is_window_complete(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  return count <= pairs.size() && needed_reach(pairs, count) <= pairs.reach;
}

internal::Spectral_pairs internal::resolved_nearest_first(const internal::Spectral_pairs& pairs)
{
  const Eigen::ArrayXd errors = pairs.energies.array() - pairs.quotients.array().square();
  double reach = pairs.reach;
  std::vector<Eigen::Index> order;
  for (Eigen::Index k = 0; k < pairs.size(); ++k)
    if (2 * std::abs(errors[k]) <= pairs.squared_images[k] ||
        pairs.squared_images[k] <= pairs.slow_energy)
      order.push_back(k);
    else
      reach = (std::min)(reach, pairs.energies[k]);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
    return std::abs(pairs.quotients[i]) < std::abs(pairs.quotients[j]);
  });
  return {pairs.quotients(order),
          pairs.energies(order),
          pairs.squared_images(order),
          pairs.of_pencil(order),
          pairs.residuals(order),
          pairs.vectors(Eigen::indexing::all, order),
          reach,
          pairs.slow_energy,
          reach < pairs.reach};
}

}  // namespace Conformal_geometry_processing
