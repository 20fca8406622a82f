// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace conformal {

/// Two aligned columns of text: labels and values.
class Table {
 public:
  void add(std::string label, std::string value)
  {
    m_rows.emplace_back(std::move(label), std::move(value));
  }

  std::string text() const;

 private:
  std::vector<std::pair<std::string, std::string>> m_rows;
};

}  // namespace conformal
