// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Text_scanner.h"

#include "io_errors.h"
#include "numbers.h"

#include <cmath>

namespace conformal {
namespace {

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
bool is_line_end(char c)
{
  return c == '\n' || c == '\r';
}

}  // namespace

void Text_scanner::fail_at(std::size_t line, const std::string& message) const
{
  throw Read_error(m_path, line, message);
}

// Returns 0 if there is no line end at i
std::size_t Text_scanner::length_of_line_end(std::size_t i) const
{
  if (i >= m_text.size() || !is_line_end(m_text[i])) return 0;
  return m_text[i] == '\r' && i + 1 < m_text.size() && m_text[i + 1] == '\n' ? 2 : 1;
}

bool Text_scanner::is_continuation(std::size_t i) const
{
  return has(backslash_continues_line) && m_text[i] == '\\' && length_of_line_end(i + 1) != 0;
}

bool Text_scanner::skip_continuation()
{
  if (!is_continuation(m_position)) return false;
  m_position += 1 + length_of_line_end(m_position + 1);
  ++m_line;
  return true;
}

void Text_scanner::skip_blanks()
{
  while (m_position < m_text.size()) {
    if (is_blank(m_text[m_position]))
      ++m_position;
    else if (!skip_continuation())
      break;
  }
}

void Text_scanner::skip_blanks_and_comment()
{
  skip_blanks();
  if (m_position < m_text.size() && has(hash_comments) && m_text[m_position] == '#')
    while (m_position < m_text.size() && !is_line_end(m_text[m_position])) ++m_position;
}

bool Text_scanner::at_end_of_line()
{
  skip_blanks_and_comment();
  return m_position == m_text.size() || is_line_end(m_text[m_position]);
}

bool Text_scanner::skip_to_word(std::string_view& comment)
{
  comment = {};
  for (;;) {
    skip_blanks();
    if (m_position == m_text.size()) return false;
    if (has(hash_comments) && m_text[m_position] == '#') {
      comment = rest_of_line();
      return true;
    }
    const std::size_t length = length_of_line_end(m_position);
    if (length == 0) return true;
    m_position += length;
    ++m_line;
  }
}

bool Text_scanner::at_end()
{
  while (at_end_of_line()) {
    if (m_position == m_text.size()) return true;
    m_position += length_of_line_end(m_position);
    ++m_line;
  }
  return false;
}

std::string_view Text_scanner::rest_of_line()
{
  while (m_position < m_text.size() && is_blank(m_text[m_position])) ++m_position;
  const std::size_t begin = m_position;
  while (m_position < m_text.size() && !is_line_end(m_text[m_position])) ++m_position;
  std::size_t end = m_position;
  while (end > begin && is_blank(m_text[end - 1])) --end;
  return m_text.substr(begin, end - begin);
}

std::string_view Text_scanner::word(const char* wanted)
{
  if (at_end()) fail(std::string("the file ends, wanted ") + wanted);
  const std::size_t begin = m_position;
  for (; m_position < m_text.size(); ++m_position) {
    const char c = m_text[m_position];
    if (is_blank(c) || is_line_end(c) || is_continuation(m_position)) break;
    if (c == '#' && has(hash_ends_words)) break;
  }
  return m_text.substr(begin, m_position - begin);
}

double Text_scanner::number(const char* wanted)
{
  const std::string_view text = word(wanted);
  const auto value = parse_double(text);
  if (!value) fail(in_quotes(text) + " is not a number, wanted " + wanted);
  return *value;
}

double Text_scanner::coordinate(const char* wanted)
{
  const std::string_view text = word(wanted);
  const auto value = parse_double(text);
  if (!value) fail(in_quotes(text) + " is not a number, wanted " + wanted);
  if (!std::isfinite(*value)) fail(in_quotes(text) + " is not finite, wanted " + wanted);
  return *value;
}

double Text_scanner::line_coordinate(const char* wanted)
{
  if (at_end_of_line()) fail(std::string("the line ends, wanted ") + wanted);
  return coordinate(wanted);
}

std::int64_t Text_scanner::integer(const char* wanted)
{
  const std::string_view text = word(wanted);
  const auto value = parse_integer(text);
  if (!value) fail(in_quotes(text) + " is not an integer, wanted " + wanted);
  return *value;
}

void Text_scanner::check_count(std::int64_t count, std::size_t bytes_each, const char* things) const
{
  if (count < 0) fail(std::to_string(count) + ' ' + things + ", wanted a count");
  const std::size_t most = (bytes_left() + 1) / bytes_each;  // the last one needs no separator
  if (static_cast<std::uint64_t>(count) > most)
    fail(std::to_string(count) + ' ' + things + ", but the " + std::to_string(bytes_left()) +
         " bytes left hold at most " + std::to_string(most));
}

}  // namespace conformal
