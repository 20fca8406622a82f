// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "inflate_blocks.h"

#ifndef __EMSCRIPTEN__
#include <zlib.h>
#endif

namespace conformal {

#ifdef __EMSCRIPTEN__
std::optional<std::string> inflated(const Packed_blocks&, std::string_view)
{
  return {};
}
#else
std::optional<std::string> inflated(const Packed_blocks& blocks, std::string_view bytes)
{
  const std::size_t largest_ratio = 1100;  // of deflate: a small file cannot ask for much memory
  std::string result;
  for (std::size_t i = 0; i < blocks.packed.size(); ++i) {
    const bool is_last = i + 1 == blocks.packed.size();
    const std::size_t size = is_last && blocks.last_size > 0 ? blocks.last_size : blocks.size;
    const std::size_t packed = blocks.packed[i], begin = result.size();
    if (packed > bytes.size() || size / largest_ratio > packed) return {};
    result.resize(begin + size);
    uLongf written = size;
    const int status = uncompress(reinterpret_cast<Bytef*>(result.data() + begin), &written,
                                  reinterpret_cast<const Bytef*>(bytes.data()), packed);
    if (status != Z_OK || written != size) return {};
    bytes.remove_prefix(packed);
  }
  return result;
}
#endif

}  // namespace conformal
