// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace conformal {

/// a number with so many significant digits, in the spelling of C whatever the locale is
std::string text_of(double value, int digits = 6);

/// the text with `\x1b` and the like for what would steer a terminal: control characters other than
/// line ends, and bytes that are not UTF-8
std::string printable(std::string_view text);

/// likewise, with blanks for line ends
std::string printable_line(std::string_view text);

/// `1 face`, `2 faces`
std::string count_of(std::size_t count, std::string_view noun);

}  // namespace conformal
