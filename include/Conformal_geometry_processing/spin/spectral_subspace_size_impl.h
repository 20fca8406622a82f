// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPECTRAL_SUBSPACE_SIZE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPECTRAL_SUBSPACE_SIZE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/spectral_subspace_size.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE int internal::first_subspace_size(int count)
{
  return count + 2 * static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))) + 2;
}

CGP_INLINE int internal::next_subspace_size(int size, int most,
                                            const internal::Spectral_pairs& pairs, int count)
{
  const bool is_estimate = count <= pairs.size() && pairs.reach > 0;
  const double needed = is_estimate ? needed_reach(pairs, count) / pairs.reach : 2;
  const double growth = std::clamp(1.1 * needed, 1.25, 2.);
  return (std::min)(most, static_cast<int>(std::ceil(size * growth)));
}

CGP_INLINE int internal::largest_subspace_size(int count)
{
  return count + 128;
}

}  // namespace Conformal_geometry_processing

#endif
