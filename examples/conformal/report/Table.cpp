// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Table.h"

#include <algorithm>

namespace conformal {

std::string Table::text() const
{
  std::size_t width = 0;
  for (const auto& [label, value] : m_rows) width = std::max(width, label.size());
  std::string text;
  for (const auto& [label, value] : m_rows)
    text += label + std::string(width + 2 - label.size(), ' ') + value + '\n';
  return text;
}

}  // namespace conformal
