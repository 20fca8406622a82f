// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace cgp_benchmark {

/// Measured values, as one line of JSON
class Record {
 public:
  Record& add(const std::string& key, double value)
  {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return add_text(key, std::isfinite(value) ? digits : "null");
  }

  Record& add(const std::string& key, int value) { return add_text(key, std::to_string(value)); }

  Record& add(const std::string& key, const std::string& value)
  {
    std::string quoted;
    for (const char c : value) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return add_text(key, "\"" + quoted + "\"");
  }

  void print() const
  {
    std::printf("{%s}\n", m_text.c_str());
    std::fflush(stdout);
  }

 private:
  Record& add_text(const std::string& key, const std::string& value)
  {
    m_text += (m_text.empty() ? "\"" : ", \"") + key + "\": " + value;
    return *this;
  }

  std::string m_text;
};

}  // namespace cgp_benchmark
