// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace conformal {

/// The words of a text file in order, with the number of the line each is on. Blanks separate
/// words; lines end with LF, CR LF or CR. Every error is a `Read_error` with path and line.
class Text_scanner {
 public:
  /// `#` begins a comment where a word could begin; also inside a word; a backslash at the end of
  /// a line joins it to the next one
  enum Option { plain = 0, hash_comments = 1, hash_ends_words = 2, backslash_continues_line = 4 };

  /// \param text must outlive the scanner; `line` is the number of its first line
  Text_scanner(std::string_view text, std::string path, int options, std::size_t line = 1)
      : m_text(text), m_path(std::move(path)), m_options(options), m_line(line)
  {}

  /// the line of the word read last
  std::size_t line() const { return m_line; }
  std::size_t bytes_left() const { return m_text.size() - m_position; }

  /// Whether no word is left, in the file or on this line. Blanks are skipped.
  bool at_end();
  bool at_end_of_line();

  /// Skips to the next word or, if comments are enabled, to the next comment on its own line: then
  /// `comment` is the comment with its `#`, and it is skipped. Returns false at the end of the
  /// file.
  bool skip_to_word(std::string_view& comment);

  /// the rest of this line without the blanks around it; comments and continuations are not special
  std::string_view rest_of_line();

  /// the next word, on whatever line; `wanted` is for the message if there is none
  std::string_view word(const char* wanted);

  /// the next word as a number: any double; a finite one; a finite one on this line; an integer
  double number(const char* wanted);
  double coordinate(const char* wanted);
  double line_coordinate(const char* wanted);
  std::int64_t integer(const char* wanted);

  /// Refuses a count of things of at least so many bytes each that cannot be in the rest.
  void check_count(std::int64_t count, std::size_t bytes_each, const char* things) const;

  [[noreturn]] void fail(const std::string& message) const { fail_at(m_line, message); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;

 private:
  bool has(Option option) const { return (m_options & option) != 0; }
  std::size_t length_of_line_end(std::size_t i) const;
  bool is_continuation(std::size_t i) const;
  bool skip_continuation();
  void skip_blanks();
  void skip_blanks_and_comment();

  std::string_view m_text;
  std::string m_path;
  int m_options;
  std::size_t m_line;
  std::size_t m_position = 0;
};

}  // namespace conformal
