// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_jpeg.h"

#include "conformal/io/file/io_errors.h"

#include <array>
#include <csetjmp>
#include <cstdio>  // before jpeglib.h, which does not include it

#include <jpeglib.h>

namespace conformal {
namespace {

struct Jpeg_errors {
  jpeg_error_mgr manager;  // first, so that its address is that of the whole
  std::jmp_buf place;
  std::array<char, JMSG_LENGTH_MAX> message;
};

[[noreturn]] void leave(j_common_ptr info)
{
  std::longjmp(reinterpret_cast<Jpeg_errors*>(info->err)->place, 1);
}

extern "C" void end_with_jpeg_error(j_common_ptr info)
{
  info->err->format_message(info, reinterpret_cast<Jpeg_errors*>(info->err)->message.data());
  leave(info);
}

// A negative level is damage, for which the library would invent samples.
extern "C" void end_with_jpeg_damage(j_common_ptr info, int level)
{
  if (level < 0) end_with_jpeg_error(info);
}

// A small file may ask for a picture to be refined ten thousand times.
extern "C" void end_after_many_scans(j_common_ptr info)
{
  if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= 500) return;
  auto& message = reinterpret_cast<Jpeg_errors*>(info->err)->message;
  std::snprintf(message.data(), message.size(), "more than 500 scans");
  leave(info);
}

class Jpeg_decoder {
 public:
  Jpeg_decoder(std::string_view bytes, const std::string& path) : m_bytes(bytes), m_path(path)
  {
    m_info.err = jpeg_std_error(&m_errors.manager);
    m_errors.manager.error_exit = end_with_jpeg_error;
    m_errors.manager.emit_message = end_with_jpeg_damage;
    m_progress.progress_monitor = end_after_many_scans;
  }
  ~Jpeg_decoder() { jpeg_destroy_decompress(&m_info); }
  Jpeg_decoder(const Jpeg_decoder&) = delete;
  Jpeg_decoder& operator=(const Jpeg_decoder&) = delete;

  Picture decode()
  {
    guarded([this] { read_header(); });
    const bool is_gray = m_info.out_color_space == JCS_GRAYSCALE;
    Picture picture(m_path, m_info.image_width, m_info.image_height, is_gray ? 1 : 3, 255);
    std::string bytes(picture.samples(), '\0');
    guarded([&] { read_rows(bytes.data(), picture.samples_per_row()); });
    picture.set_all(bytes);
    return picture;
  }

 private:
  // libjpeg ends by a jump to here: the step must not create anything that has a destructor.
  template <class Step>
  void guarded(const Step& step)
  {
    if (setjmp(m_errors.place) != 0)
      throw Read_error(
          m_path, 0,
          std::string("cannot be understood as JPEG picture: ") + m_errors.message.data());
    step();
  }

  // The luminance of colours is what is stored.
  void read_header()
  {
    jpeg_create_decompress(&m_info);
    m_info.progress = &m_progress;
    jpeg_mem_src(&m_info, reinterpret_cast<const unsigned char*>(m_bytes.data()),
                 static_cast<unsigned long>(m_bytes.size()));
    jpeg_read_header(&m_info, TRUE);
    m_info.out_color_space = m_info.jpeg_color_space == JCS_RGB ? JCS_RGB : JCS_GRAYSCALE;
  }

  void read_rows(char* bytes, std::size_t size_of_row)
  {
    jpeg_start_decompress(&m_info);
    while (m_info.output_scanline < m_info.output_height) {
      auto* row = reinterpret_cast<JSAMPROW>(bytes + m_info.output_scanline * size_of_row);
      jpeg_read_scanlines(&m_info, &row, 1);
    }
    jpeg_finish_decompress(&m_info);
  }

  std::string_view m_bytes;
  const std::string& m_path;
  Jpeg_errors m_errors{};
  jpeg_progress_mgr m_progress{};
  jpeg_decompress_struct m_info{};
};

}  // namespace

Picture parse_jpeg(std::string_view bytes, const std::string& path)
{
  return Jpeg_decoder(bytes, path).decode();
}

}  // namespace conformal
