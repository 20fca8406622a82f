// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "number_rows.h"

#include "io_errors.h"
#include "numbers.h"

#include <algorithm>

namespace conformal {

std::vector<Number_row> number_rows(std::string_view text, const std::string& path)
{
  constexpr const char* blanks = " \t\r,;";
  std::vector<Number_row> rows;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view rest = text.substr(0, std::min(end, text.find('#')));
    rows.push_back({line, {}, rest.size() < end});
    text.remove_prefix(std::min(end + 1, text.size()));
    while (true) {
      rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
      if (rest.empty()) break;
      const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
      const auto number = parse_double(word);
      if (!number) throw Read_error(path, line, in_quotes(word) + " is not a number");
      rows.back().numbers.push_back(*number);
      rest.remove_prefix(word.size());
    }
  }
  return rows;
}

}  // namespace conformal
