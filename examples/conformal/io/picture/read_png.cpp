// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_png.h"

#include "conformal/io/file/io_errors.h"

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstring>

namespace conformal {
namespace {

using Message = std::array<char, 200>;

extern "C" void read_png_bytes(png_structp png, png_bytep begin, png_size_t size)
{
  auto& left = *static_cast<std::string_view*>(png_get_io_ptr(png));
  if (size > left.size()) png_error(png, "the file ends");
  std::memcpy(begin, left.data(), size);
  left.remove_prefix(size);
}

extern "C" void end_with_png_error(png_structp png, png_const_charp text)
{
  auto& message = *static_cast<Message*>(png_get_error_ptr(png));
  std::snprintf(message.data(), message.size(), "%s", text);
  png_longjmp(png, 1);
}

extern "C" void ignore_png_warning(png_structp, png_const_charp) {}

class Png_decoder {
 public:
  Png_decoder(std::string_view bytes, const std::string& path) : m_bytes(bytes), m_path(path)
  {
    m_png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &m_message, end_with_png_error,
                                   ignore_png_warning);
    m_info = m_png == nullptr ? nullptr : png_create_info_struct(m_png);
    if (m_info == nullptr) fail("no memory for libpng");
    png_set_read_fn(m_png, &m_bytes, read_png_bytes);
  }
  ~Png_decoder() { png_destroy_read_struct(&m_png, &m_info, nullptr); }
  Png_decoder(const Png_decoder&) = delete;
  Png_decoder& operator=(const Png_decoder&) = delete;

  Picture decode()
  {
    guarded([this] { read_header(); });
    const int channels = png_get_channels(m_png, m_info);
    const std::size_t bytes_per_sample = png_get_bit_depth(m_png, m_info) / 8;
    Picture picture(m_path, png_get_image_width(m_png, m_info), png_get_image_height(m_png, m_info),
                    channels, bytes_per_sample == 2 ? 65535 : 255);
    std::string bytes(picture.samples() * bytes_per_sample, '\0');
    std::vector<png_bytep> rows;
    for (std::size_t i = 0; i < picture.height(); ++i)
      rows.push_back(reinterpret_cast<png_bytep>(bytes.data()) +
                     i * picture.samples_per_row() * bytes_per_sample);
    guarded([&] { read_rows(rows.data()); });
    picture.set_all(bytes);
    return picture;
  }

 private:
  // libpng ends by a jump to here: the step must not create anything that has a destructor.
  template <class Step>
  void guarded(const Step& step)
  {
    if (setjmp(png_jmpbuf(m_png)) != 0) fail(m_message.data());
    step();
  }

  // Asks for gray or colours of 8 or 16 bits.
  void read_header()
  {
    png_read_info(m_png, m_info);
    png_set_expand(m_png);
    png_set_strip_alpha(m_png);
    png_set_interlace_handling(m_png);
    png_read_update_info(m_png, m_info);
  }

  void read_rows(png_bytepp rows)
  {
    png_read_image(m_png, rows);
    png_read_end(m_png, nullptr);
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Read_error(m_path, 0, "cannot be understood as PNG picture: " + message);
  }

  std::string_view m_bytes;
  const std::string& m_path;
  Message m_message{};
  png_structp m_png = nullptr;
  png_infop m_info = nullptr;
};

}  // namespace

Picture parse_png(std::string_view bytes, const std::string& path)
{
  return Png_decoder(bytes, path).decode();
}

}  // namespace conformal
