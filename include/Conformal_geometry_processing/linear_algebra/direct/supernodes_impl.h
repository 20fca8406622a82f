// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODES_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/direct/supernodes.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE std::vector<int> fundamental_supernodes(const std::vector<int>& parent,
                                                   const std::vector<int>& count)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int n = static_cast<int>(parent.size());
  std::vector<int> children(at(n), 0), first;
  for (int p : parent)
    if (p >= 0) ++children[at(p)];
  for (int j = 0; j < n; ++j)
    if (j == 0 || parent[at(j - 1)] != j || count[at(j - 1)] != count[at(j)] + 1 ||
        children[at(j)] > 1)
      first.push_back(j);
  first.push_back(n);
  return first;
}

/// Returns whether a supernode of this width may have this share of zeros among its entries: the
/// narrower it is, the more it gains from the dense kernels.
CGP_INLINE bool is_worth_its_zeros(int width, double zeros)
{
  return width <= 4 || (width <= 16 && zeros < 0.8) || (width <= 48 && zeros < 0.1) || zeros < 0.05;
}

}  // namespace internal

CGP_INLINE std::vector<int> relaxed_supernodes(const std::vector<int>& parent,
                                               const std::vector<int>& count)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<int> first = internal::fundamental_supernodes(parent, count);
  const int size = static_cast<int>(first.size()) - 1;
  // Of the group that begins with supernode s: number of columns, rows of the first column, zeros.
  std::vector<int> width(at(size)), height(at(size));
  std::vector<double> zeros(at(size), 0);
  std::vector<char> is_begin(at(size) + 1, 1);
  for (int s = size - 1; s >= 0; --s) {
    width[at(s)] = first[at(s + 1)] - first[at(s)];
    height[at(s)] = count[at(first[at(s)])];
    const int up = parent[at(first[at(s + 1)] - 1)];
    if (s + 1 == size || up < first[at(s + 1)] || up >= first[at(s + 2)]) continue;
    const int w = width[at(s)] + width[at(s + 1)], h = width[at(s)] + height[at(s + 1)];
    const double added = static_cast<double>(width[at(s)]) * (h - height[at(s)]);
    const double all = zeros[at(s + 1)] + added;
    const double entries = w * (w + 1.) / 2 + static_cast<double>(w) * (h - w);
    if (added > 0 && !internal::is_worth_its_zeros(w, all / entries)) continue;
    width[at(s)] = w;
    height[at(s)] = h;
    zeros[at(s)] = all;
    is_begin[at(s + 1)] = 0;
  }
  std::vector<int> result;
  for (int s = 0; s < size; ++s) {
    if (!is_begin[at(s)]) continue;
    const int pieces = (width[at(s)] + max_supernode_width - 1) / max_supernode_width;
    for (int p = 0; p < pieces; ++p)
      result.push_back(first[at(s)] +
                       static_cast<int>(static_cast<long long>(width[at(s)]) * p / pieces));
  }
  result.push_back(first.back());
  return result;
}

}  // namespace Conformal_geometry_processing

#endif
