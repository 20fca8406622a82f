// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_TABLE_H
#define CONFORMAL_TABLE_H

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace conformal {

/// a number with so many significant digits, in the spelling of C whatever the locale is
std::string text_of(double value, int digits = 6);

/// `1 face`, `2 faces`
std::string count_of(std::size_t count, std::string_view noun);

/// Two aligned columns of text, what and how much.
class Table {
 public:
  void add(std::string label, std::string value)
  {
    m_rows.emplace_back(std::move(label), std::move(value));
  }
  void add(std::string label, double value) { add(std::move(label), text_of(value)); }
  void add(std::string label, int value) { add(std::move(label), std::to_string(value)); }

  std::string text() const;

 private:
  std::vector<std::pair<std::string, std::string>> m_rows;
};

}  // namespace conformal

#endif
