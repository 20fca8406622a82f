// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// blocks of bytes, each compressed by zlib
struct Packed_blocks {
  std::size_t size = 0, last_size = 0;  ///< of a block and of the last one, before; 0: it is whole
  std::vector<std::size_t> packed;      ///< of each, as they are in a file
};

/// \brief The bytes of the blocks, or nothing if they are not what zlib has made, or too many for
/// what they are packed in. The page of the studio has no zlib, and reads none.
std::optional<std::string> inflated(const Packed_blocks& blocks, std::string_view bytes);

}  // namespace conformal
