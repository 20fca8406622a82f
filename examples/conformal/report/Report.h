// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_REPORT_REPORT_H
#define CONFORMAL_REPORT_REPORT_H

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace conformal {

/// The results of a command, in order; `to_json()` writes them.
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

  /// Adds seconds to the stage `seconds/<stage>`.
  void add_seconds(const std::string& stage, double seconds);

  const std::vector<std::pair<std::string, Value>>& entries() const { return m_entries; }

 private:
  std::vector<std::pair<std::string, Value>> m_entries;
  std::unordered_map<std::string, std::size_t> m_index;  // of the entry of a place
};

/// the report as an indented JSON object, UTF-8, with a line break at its end
std::string to_json(const Report& report);

}  // namespace conformal

#endif
