// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace conformal {

// Numbers as mesh files spell them, whatever the locale of the process says.

/// The double nearest to a decimal; too large is infinite, too small is zero, `nan` and `inf` are
/// accepted, a leading `+` too. Nothing if the word is not a number from its first to its last
/// character.
std::optional<double> parse_double(std::string_view word);

/// the same, rounded once, to float
std::optional<float> parse_float(std::string_view word);

/// A decimal integer of at most 64 bits, or nothing.
std::optional<std::int64_t> parse_integer(std::string_view word);

/// Appends the shortest decimal that reads back as the same number.
void append_number(std::string& text, double value);
void append_number(std::string& text, float value);
void append_number(std::string& text, std::int64_t value);

/// the word for an error message: in quotes, shortened, with unprintable bytes as `?`
std::string in_quotes(std::string_view word);

}  // namespace conformal
