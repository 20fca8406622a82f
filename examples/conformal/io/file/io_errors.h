// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace conformal {

/// A file cannot be read or parsed: `path:line: contents, expectation`.
class Read_error : public std::runtime_error {
 public:
  /// \param line counted from 1; 0 where the file has no lines or the fault is in no line
  Read_error(const std::string& path, std::size_t line, const std::string& message)
      : std::runtime_error(path + (line == 0 ? "" : ":" + std::to_string(line)) + ": " + message),
        m_line(line)
  {}

  std::size_t line() const noexcept { return m_line; }

 private:
  std::size_t m_line;
};

/// A file that cannot be written: `path: what failed: the system's reason`.
class Write_error : public std::runtime_error {
 public:
  Write_error(const std::string& path, const std::string& message)
      : std::runtime_error(path + ": " + message)
  {}
};

}  // namespace conformal
