// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_pnm.h"

#include "conformal/io/file/Text_scanner.h"

namespace conformal {
namespace {

// Netpbm's own library ends the program at an error; the format is three numbers and the samples.
class Pnm_decoder {
 public:
  Pnm_decoder(std::string_view bytes, const std::string& path)
      : m_bytes(bytes),
        m_path(path),
        m_scanner(bytes, path, Text_scanner::hash_comments | Text_scanner::hash_ends_words)
  {}

  Picture decode()
  {
    const char kind = m_scanner.word("P2, P3, P5 or P6")[1];
    const std::uint64_t width = number("the width", 0, 1 << 30);
    const std::uint64_t height = number("the height", 0, 1 << 30);
    const int white = static_cast<int>(number("the largest value", 1, 65535));
    const int channels = kind == '2' || kind == '5' ? 1 : 3;
    const bool is_plain = kind == '2' || kind == '3';
    const std::uint64_t samples = width * height * static_cast<std::uint64_t>(channels);
    const std::uint64_t bytes_each = is_plain || white > 255 ? 2 : 1;  // plain: a blank and a digit
    require_bytes(samples, samples * bytes_each + (is_plain ? 0 : 1));
    Picture picture(m_path, width, height, channels, white);
    is_plain ? read_numbers(picture) : read_bytes(picture);
    return picture;
  }

 private:
  std::uint64_t number(const char* what, std::int64_t least, std::int64_t most)
  {
    const std::int64_t value = m_scanner.integer(what);
    if (value < least || value > most)
      m_scanner.fail(std::string(what) + " is " + std::to_string(value) + ", wanted " +
                     std::to_string(least) + " to " + std::to_string(most));
    return static_cast<std::uint64_t>(value);
  }

  void require_bytes(std::uint64_t samples, std::uint64_t bytes) const
  {
    if (bytes <= m_scanner.bytes_left()) return;
    m_scanner.fail("the file ends: " + std::to_string(m_scanner.bytes_left()) +
                   " bytes for a picture of " + std::to_string(samples) + " samples");
  }

  void read_numbers(Picture& picture)
  {
    for (std::size_t i = 0; i < picture.samples(); ++i)
      picture.set(i, static_cast<int>(number("a sample", 0, picture.white())));
  }

  void read_bytes(Picture& picture)
  {
    const std::size_t size = picture.samples() * (picture.white() > 255 ? 2 : 1);
    picture.set_all(m_bytes.substr(m_bytes.size() - m_scanner.bytes_left() + 1).substr(0, size));
    if (picture.largest() > picture.white())
      m_scanner.fail("a sample is " + std::to_string(picture.largest()) + ", wanted at most " +
                     std::to_string(picture.white()));
  }

  std::string_view m_bytes;
  const std::string& m_path;
  Text_scanner m_scanner;
};

}  // namespace

Picture parse_pnm(std::string_view bytes, const std::string& path)
{
  return Pnm_decoder(bytes, path).decode();
}

}  // namespace conformal
