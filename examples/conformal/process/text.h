// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_PROCESS_TEXT_H
#define CONFORMAL_PROCESS_TEXT_H

#include <cstddef>
#include <string>
#include <string_view>

namespace conformal {

/// a number with so many significant digits, in the spelling of C whatever the locale is
std::string text_of(double value, int digits = 6);

/// `1 face`, `2 faces`
std::string count_of(std::size_t count, std::string_view noun);

}  // namespace conformal

#endif
