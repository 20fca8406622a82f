// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace conformal {

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
constexpr bool machine_is_little_endian = false;
#else
constexpr bool machine_is_little_endian = true;
#endif

/// the number whose bytes begin at that address, lowest first
template <class Number>
Number little_endian(const char* bytes)
{
  std::array<char, sizeof(Number)> copy;
  std::copy_n(bytes, sizeof(Number), copy.begin());
  if (!machine_is_little_endian) std::reverse(copy.begin(), copy.end());
  Number number;
  std::memcpy(&number, copy.data(), sizeof(Number));
  return number;
}

/// Appends bytes of a number of this machine, lowest first.
inline void append_little_endian(std::string& bytes, const unsigned char* number, std::size_t size)
{
  bytes.append(reinterpret_cast<const char*>(number), size);
  if (!machine_is_little_endian)
    std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(size), bytes.end());
}

template <class Number>
void append_little_endian(std::string& bytes, Number number)
{
  std::array<unsigned char, sizeof(Number)> copy;
  std::memcpy(copy.data(), &number, sizeof(Number));
  append_little_endian(bytes, copy.data(), copy.size());
}

}  // namespace conformal
