// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

// Common functions of the targets of libFuzzer. The first byte of an input selects the operation on
// the others, which form a file.

namespace fuzz {

/// \brief Brings forth the next input: a seed where there is none yet, else half of the time our
/// own damage and half of the time libFuzzer's. \param seeds file for each choice
template <class Mutator>
std::size_t guided_mutant(std::uint8_t* data, std::size_t size, std::size_t max_size,
                          unsigned int random, const std::vector<std::string>& seeds)
{
  Mutator mutator(random);
  if (size >= 2 && mutator.below(2) == 0)
    return 1 + LLVMFuzzerMutate(data + 1, size - 1, max_size - 1);
  if (size < 2) data[0] = static_cast<std::uint8_t>(mutator.below(256));
  const std::string file =
      size < 2 ? seeds[data[0] % seeds.size()]
               : mutator.mutant(std::string(reinterpret_cast<char*>(data) + 1, size - 1));
  const std::size_t length = std::min(file.size(), max_size - 1);
  std::memcpy(data + 1, file.data(), length);
  return 1 + length;
}

}  // namespace fuzz
