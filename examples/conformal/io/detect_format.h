// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_IO_DETECT_FORMAT_H
#define CONFORMAL_IO_DETECT_FORMAT_H

#include "Surface_file.h"

#include <optional>
#include <string>
#include <string_view>

namespace conformal {

/// the format that the extension of the path stands for, in any case of letters
std::optional<File_format> format_of_extension(const std::string& path);

/// `OFF`, `OBJ`, ...
const char* name_of(File_format format);

/// How many bytes of the text the keyword of an OFF header takes (`OFF`, `STCNOFF`, `4nOFF`, ...);
/// 0 if it does not begin with one.
std::size_t length_of_off_keyword(std::string_view text);

/// Detects the format of a file by its content if that is unambiguous, otherwise by its extension.
/// \throws Read_error naming the actual format (gzip, UTF-16, HTML, ...)
File_format detect_format(std::string_view bytes, const std::string& path);

/// Throws as `detect_format` for files that are not mesh files; otherwise returns the bytes without
/// a UTF-8 byte order mark.
std::string_view checked_bytes(std::string_view bytes, const std::string& path);

}  // namespace conformal

#endif
