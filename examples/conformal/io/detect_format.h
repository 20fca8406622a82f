// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <optional>
#include <string>
#include <string_view>

namespace conformal {

/// the format that the extension of the path stands for, in any case of letters
std::optional<File_format> format_of_extension(const std::string& path);

/// `OFF`, `OBJ`, ...
const char* name_of(File_format format);

/// Detects the format of a file by its content if that is unambiguous, otherwise by its extension.
/// \throws Read_error as `checked_bytes()`, and for unknown content
File_format detect_format(std::string_view bytes, const std::string& path);

}  // namespace conformal
