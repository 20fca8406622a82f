// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Grid.h"
#include "Table.h"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace conformal {

/// \brief The results of a command, in order: each has a place in the JSON report, a row in the
/// tables on standard output, or both.
///
/// A place is a path, `result/scale/min`; numbers that are not finite become null.
class Report {
 public:
  using Value = std::variant<std::nullptr_t, bool, std::int64_t, double, std::string,
                             std::vector<int>, std::vector<double>, std::vector<std::string>>;

  /// Sets the value of a place, which stays where it was if it is known.
  void set(const std::string& place, Value value);
  void set(const std::string& place, bool value) { set(place, Value(value)); }
  void set(const std::string& place, int value) { set(place, Value(std::int64_t{value})); }
  void set(const std::string& place, double value) { set(place, Value(value)); }
  void set(const std::string& place, const char* value) { set(place, Value(std::string(value))); }

  /// Adds a row to the table.
  void show(const std::string& label, const std::string& text) { m_table.add(label, text); }

  /// Adds a grid, which stands apart from the tables before and after it.
  void show(const Grid& grid);

  /// Sets a place and adds a row.
  void tell(const std::string& place, const std::string& label, double value, int digits = 6);
  void tell(const std::string& place, const std::string& label, int value);

  /// Ends a table: the next row begins another one.
  void end_table();

  const std::vector<std::pair<std::string, Value>>& entries() const { return m_entries; }

  /// all tables and grids, with an empty line between two
  std::string text() const;

 private:
  std::vector<std::pair<std::string, Value>> m_entries;
  std::unordered_map<std::string, std::size_t> m_index;  // of the entry of a place
  std::string m_text;                                    // of the tables before the last one
  Table m_table;
};

}  // namespace conformal
