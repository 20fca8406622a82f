// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// The contents of a line of text
struct Number_row {
  std::size_t line;  ///< counted from 1
  std::vector<double> numbers;
  bool has_comment;
};

/// \brief The numbers of a text, line by line, also of those without any: words between blanks,
/// commas or semicolons; `#` begins a comment.
/// \throws Read_error for a word that is not a number
std::vector<Number_row> number_rows(std::string_view text, const std::string& path);

}  // namespace conformal
