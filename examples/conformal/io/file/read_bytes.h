// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace conformal {

/// The largest file that is read, in bytes: 16 GiB, far above what indices of 31 bits can use.
constexpr std::uint64_t maximum_file_size = std::uint64_t{1} << 34;

/// Returns the whole content of a file (or pipe). \throws Read_error with the system's reason for a
/// path that is missing, a directory or unreadable, and for an empty or too large file
/// \param wanted the expected kind of file, for messages
std::string read_bytes(const std::string& path, const std::string& wanted = "a mesh file");

}  // namespace conformal
