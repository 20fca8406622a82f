// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace conformal {

/// Columns of numbers under their headings, aligned to the right.
class Grid {
 public:
  explicit Grid(std::vector<std::string> headings) { add(std::move(headings)); }

  /// \pre as many cells as headings
  void add(std::vector<std::string> cells) { m_rows.push_back(std::move(cells)); }

  std::string text() const;

 private:
  std::vector<std::vector<std::string>> m_rows;
};

}  // namespace conformal
