// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace conformal {

/// a tag of an XML file
struct Xml_tag {
  std::size_t line = 1;
  std::string_view name;               ///< without a namespace
  bool opens = false, closes = false;  ///< `<g>`, `</g>`; both: `<g/>`
  std::vector<std::pair<std::string_view, std::string_view>> attributes;

  std::optional<std::string_view> attribute(std::string_view wanted) const;
};

/// The tags of an XML file in order; comments, declarations and text between tags are skipped.
/// Every error is a `Read_error` with path and line.
class Xml_scanner {
 public:
  /// \param text must outlive the scanner and its tags
  Xml_scanner(std::string_view text, std::string path) : m_text(text), m_path(std::move(path)) {}

  /// the next tag, nothing at the end of the file
  std::optional<Xml_tag> next();

  /// the text from the last tag on, up to the next one
  std::string_view text() const { return m_text.substr(0, m_text.find('<')); }

  [[noreturn]] void fail(const std::string& message) const;

 private:
  void advance(std::size_t count);
  void skip_past(std::string_view end, const char* what);
  void skip_blanks();
  std::string_view name();
  std::string_view value();

  std::string_view m_text;
  std::string m_path;
  std::size_t m_line = 1;
};

}  // namespace conformal
