// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "checkerboard.h"

#include <algorithm>
#include <cstdint>

namespace conformal {
namespace {

void append_big_endian(std::string& bytes, std::uint32_t number)
{
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift));
}

// the cyclic redundancy check of PNG (polynomial 0xedb88320, bits reversed)
std::uint32_t checksum_crc(const std::string& bytes)
{
  std::uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
  }
  return ~crc;
}

std::uint32_t checksum_adler(const std::string& bytes)
{
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

void append_chunk(std::string& png, const std::string& type, const std::string& data)
{
  append_big_endian(png, static_cast<std::uint32_t>(data.size()));
  png += type + data;
  append_big_endian(png, checksum_crc(type + data));
}

void append_16_bits(std::string& bytes, std::size_t number)
{
  bytes += static_cast<char>(static_cast<unsigned char>(number));
  bytes += static_cast<char>(static_cast<unsigned char>(number >> 8));
}

// A zlib stream of stored blocks: the picture is small, so it need not be compressed.
std::string stored(const std::string& bytes)
{
  constexpr std::size_t largest = 65535;
  std::string stream = "\x78\x01";
  for (std::size_t begin = 0; begin < bytes.size(); begin += largest) {
    const std::size_t size = std::min(largest, bytes.size() - begin);
    stream += begin + size == bytes.size() ? '\1' : '\0';
    append_16_bits(stream, size);
    append_16_bits(stream, ~size);
    stream.append(bytes, begin, size);
  }
  append_big_endian(stream, checksum_adler(bytes));
  return stream;
}

}  // namespace

std::string checkerboard_png(std::size_t squares, std::size_t size)
{
  const std::size_t side = squares * size;
  std::string pixels;
  for (std::size_t row = 0; row < side; ++row) {
    pixels += '\0';  // the row is not filtered
    for (std::size_t column = 0; column < side; ++column)
      pixels += (row / size + column / size) % 2 == 0 ? "\xff\xff\xff" : "\x5a\x78\xa0";
  }
  std::string header;
  append_big_endian(header, static_cast<std::uint32_t>(side));
  append_big_endian(header, static_cast<std::uint32_t>(side));
  header += std::string("\x08\x02\0\0\0", 5);  // 8 bits of red, green and blue
  std::string png = "\x89PNG\r\n\x1a\n";
  append_chunk(png, "IHDR", header);
  append_chunk(png, "IDAT", stored(pixels));
  append_chunk(png, "IEND", "");
  return png;
}

}  // namespace conformal
