// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/spectral_subspace_size.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

int internal::first_subspace_size(int count)
{
  return count + 2 * static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))) + 2;
}

int internal::next_subspace_size(int size, int most, const internal::Spectral_pairs& pairs,
                                 int count)
{
  const bool is_estimate = count <= pairs.size() && pairs.reach > 0;
  const double needed = is_estimate ? needed_reach(pairs, count) / pairs.reach : 2;
  const double growth = std::clamp(1.1 * needed, 1.25, 2.);
  return (std::min)(most, static_cast<int>(std::ceil(size * growth)));
}

int internal::largest_subspace_size(int count)
{
  return count + 128;
}

}  // namespace Conformal_geometry_processing
