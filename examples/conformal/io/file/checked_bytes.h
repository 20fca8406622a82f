// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace conformal {

/// whether a text begins with another
bool starts_with(std::string_view text, std::string_view prefix);

/// the text in small letters
std::string lower(std::string_view text);

/// the text from its first word on, without blank lines and comments (`#`)
std::string_view first_words(std::string_view text);

/// the first of these words
std::string_view first_word(std::string_view text);

/// \returns the bytes without a UTF-8 byte order mark
/// \throws Read_error naming the actual format of files that hold no mesh (gzip, UTF-16, HTML, ...)
std::string_view checked_bytes(std::string_view bytes, const std::string& path);

}  // namespace conformal
