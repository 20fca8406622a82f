// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "text.h"

#include <array>
#include <charconv>
#include <cstdio>

namespace conformal {
namespace {

/// the bytes of the UTF-8 character that the text begins with; 0 if it is none, or controls a
/// terminal
std::size_t size_of_character(std::string_view text)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t size = first < 0xc2   ? 0
                           : first < 0xe0 ? 2
                           : first < 0xf0 ? 3
                           : first < 0xf5 ? 4
                                          : 0;
  if (size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool is_second_control_set = first == 0xc2 && byte(1) < 0xa0;
  return is_second_control_set ? 0 : size;
}

}  // namespace

std::string printable(std::string_view text)
{
  const std::string_view digits = "0123456789abcdef";
  std::string result;
  while (!text.empty()) {
    const std::size_t size = text[0] == '\n' ? 1 : size_of_character(text);
    const auto byte = static_cast<unsigned char>(text[0]);
    if (size == 0) result.append("\\x") += {digits[byte / 16], digits[byte % 16]};
    result += text.substr(0, size);
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return result;
}

std::string printable_line(std::string_view text)
{
  std::string line(text);
  for (char& c : line)
    if (c == '\n' || c == '\r') c = ' ';
  return printable(line);
}

std::string text_of(double value, int digits)
{
  std::array<char, 64> buffer{};
#ifdef __EMSCRIPTEN__  // has only the locale of C, and a library without to_chars() of numbers
  const int size = std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  char* const end = buffer.data() + size;
#else
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
#endif
  return {buffer.data(), end};
}

std::string count_of(std::size_t count, std::string_view noun)
{
  std::string text = std::to_string(count) + ' ' + std::string(noun);
  if (count == 1) return text;
  if (noun.size() > 2 && noun.substr(noun.size() - 2) == "ex")  // vertex, vertices
    return text.substr(0, text.size() - 2) + "ices";
  return text + 's';
}

}  // namespace conformal
