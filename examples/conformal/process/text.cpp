// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "text.h"

#include <array>
#include <charconv>

namespace conformal {

std::string text_of(double value, int digits)
{
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
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
