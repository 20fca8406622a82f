// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Grid.h"

#include <algorithm>

namespace conformal {

std::string Grid::text() const
{
  std::vector<std::size_t> widths(m_rows.front().size(), 0);
  for (const auto& row : m_rows)
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : m_rows)
    for (std::size_t i = 0; i < widths.size(); ++i) {
      text += std::string(widths[i] - row[i].size(), ' ') + row[i];
      text += i + 1 < widths.size() ? "  " : "\n";
    }
  return text;
}

}  // namespace conformal
