// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Surface_file.h"

#include "conformal/io/file/numbers.h"

#include <string>

namespace conformal {

/// Appends value i of a property, shortest for its type.
void append_value(std::string& text, const Property& property, std::size_t i);

/// Appends a blank and a number.
void append_word(std::string& text, double value);

/// the text with blanks for line ends
std::string on_one_line(std::string text);

}  // namespace conformal
