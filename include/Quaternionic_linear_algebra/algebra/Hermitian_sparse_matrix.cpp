// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace Conformal_geometry_processing {

int Sparse_pattern::find(int i, int j) const
{
  const auto begin = indices.begin() + offsets[static_cast<std::size_t>(j)];
  const auto end = indices.begin() + offsets[static_cast<std::size_t>(j) + 1];
  const auto it = std::lower_bound(begin, end, i);
  return it != end && *it == i ? static_cast<int>(it - indices.begin()) : -1;
}

std::shared_ptr<const Sparse_pattern> sparse_pattern(std::vector<std::vector<int>> columns)
{
  auto pattern = std::make_shared<Sparse_pattern>();
  pattern->offsets.push_back(0);
  for (std::vector<int>& rows : columns) {
    rows.push_back(pattern->size());
    std::sort(rows.begin(), rows.end());
    const auto end = std::unique(rows.begin(), rows.end());
    pattern->indices.insert(pattern->indices.end(), rows.begin(), end);
    pattern->offsets.push_back(pattern->size_of_entries());
    rows = {};
  }
  return pattern;
}

namespace internal {

/// Computes what `Sparse_pattern::rows()` keeps
Lower_rows lower_rows(const Sparse_pattern& pattern)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const auto for_each = [&](const auto& visit) {
    for (int j = 0; j < pattern.size(); ++j)
      for (int k = pattern.offsets[at(j)] + 1; k < pattern.offsets[at(j) + 1]; ++k)
        visit(at(pattern.indices[at(k)]), Lower_rows::Entry{j, k});
  };
  Lower_rows rows;
  rows.offsets.assign(at(pattern.size()) + 1, 0);
  for_each([&](std::size_t i, Lower_rows::Entry) { ++rows.offsets[i + 1]; });
  std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
  rows.entries.resize(at(rows.offsets.back()));
  std::vector<int> next(rows.offsets.begin(), rows.offsets.end() - 1);
  for_each([&](std::size_t i, Lower_rows::Entry e) { rows.entries[at(next[i]++)] = e; });
  return rows;
}

const Lower_rows& Kept_rows::of(const Sparse_pattern& pattern) const
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (!m_rows) m_rows = std::make_unique<const Lower_rows>(lower_rows(pattern));
  return *m_rows;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
