// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <png.h>

#include <cstdio>  // before jpeglib.h, which does not include it

#include <jpeglib.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace io_test {

/// gray of 0 to 15 in blocks of 8 by 8 pixels, of which JPEG keeps every bit
inline Eigen::ArrayXXi blocks()
{
  Eigen::ArrayXXi gray(24, 32);
  for (Eigen::Index i = 0; i < gray.rows(); ++i)
    for (Eigen::Index k = 0; k < gray.cols(); ++k)
      gray(i, k) = static_cast<int>((i / 8) * 7 + (k / 8) * 5) % 16;
  return gray;
}

/// their samples, each repeated for so many channels, in one byte or two; `last` is a channel more
inline std::string samples(int white, int channels, int bytes_each, const std::string& last = "")
{
  std::string bytes;
  const Eigen::ArrayXXi gray = blocks();
  for (Eigen::Index i = 0; i < gray.rows(); ++i)
    for (Eigen::Index k = 0; k < gray.cols(); ++k) {
      for (int c = 0; c < channels; ++c) {
        const int value = gray(i, k) * (white / 15);
        if (bytes_each == 2) bytes += static_cast<char>(value / 256);
        bytes += static_cast<char>(value % 256);
      }
      bytes += last;
    }
  return bytes;
}

inline std::string pnm(const std::string& kind, int white, const std::string& bytes)
{
  return kind + "\n32 24\n" + std::to_string(white) + '\n' + bytes;
}

inline std::string plain(const std::string& kind, int white, int channels)
{
  std::string text;
  for (const char sample : samples(white, channels, 1))
    text += std::to_string(static_cast<unsigned char>(sample)) + ' ';
  return pnm(kind, white, text);
}

extern "C" inline void append_to_string(png_structp png, png_bytep bytes, png_size_t size)
{
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), size);
}

/// the header and the rows, if there are any
inline std::string png(png_uint_32 width, png_uint_32 height, int depth, int color, int interlacing,
                       const std::string& bytes)
{
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &file, append_to_string, nullptr);
  png_set_IHDR(png, info, width, height, depth, color, interlacing, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_color palette[16];
  for (int i = 0; i < 16; ++i)
    palette[i].red = palette[i].green = palette[i].blue = static_cast<png_byte>(17 * i);
  if (color == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 16);
  png_write_info(png, info);
  if (!bytes.empty()) {
    png_set_packing(png);
    std::string copy = bytes;
    std::vector<png_bytep> rows;
    for (std::size_t i = 0; i < height; ++i)
      rows.push_back(reinterpret_cast<png_bytep>(&copy[i * (copy.size() / height)]));
    png_write_image(png, rows.data());
    png_write_end(png, nullptr);
  } else {
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), nullptr, 0);
  }
  png_destroy_write_struct(&png, &info);
  return file;
}

inline std::string empty_png(png_uint_32 width, png_uint_32 height)
{
  return png(width, height, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, "");
}

/// gray or colours, of the best quality
inline std::string jpeg(bool is_gray, bool is_progressive)
{
  jpeg_compress_struct info;
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &buffer, &size);
  info.image_width = 32;
  info.image_height = 24;
  info.input_components = is_gray ? 1 : 3;
  info.in_color_space = is_gray ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 100, TRUE);
  if (is_progressive) jpeg_simple_progression(&info);
  jpeg_start_compress(&info, TRUE);
  std::string bytes = samples(255, info.input_components, 1);
  while (info.next_scanline < info.image_height) {
    auto* row =
        reinterpret_cast<JSAMPROW>(&bytes[info.next_scanline * (bytes.size() / info.image_height)]);
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  const std::string file(reinterpret_cast<char*>(buffer), size);
  std::free(buffer);
  return file;
}

/// `blocks()` in files of every kind, with their names
inline std::vector<std::pair<std::string, std::string>> encoded_blocks()
{
  const auto whole_png = [](int depth, int color, const std::string& bytes, int interlacing = 0) {
    return png(32, 24, depth, color, interlacing, bytes);
  };
  const std::string clear8(1, '\x7f'), clear16(2, '\x7f');
  return {{"PGM", pnm("P5", 255, samples(255, 1, 1))},
          {"PGM of 4 bits", pnm("P5", 15, samples(15, 1, 1))},
          {"PGM up to 300", pnm("P5", 300, samples(300, 1, 2))},
          {"PGM of 16 bits", pnm("P5", 65535, samples(65535, 1, 2))},
          {"plain PGM", plain("P2", 255, 1)},
          {"PPM", pnm("P6", 255, samples(255, 3, 1))},
          {"PPM of 16 bits", pnm("P6", 65535, samples(65535, 3, 2))},
          {"plain PPM", plain("P3", 15, 3)},
          {"PNG of 4 bits", whole_png(4, PNG_COLOR_TYPE_GRAY, samples(15, 1, 1))},
          {"PNG", whole_png(8, PNG_COLOR_TYPE_GRAY, samples(255, 1, 1))},
          {"PNG of 16 bits", whole_png(16, PNG_COLOR_TYPE_GRAY, samples(65535, 1, 2))},
          {"interlaced PNG", whole_png(16, PNG_COLOR_TYPE_GRAY, samples(65535, 1, 2), 1)},
          {"PNG with a palette", whole_png(8, PNG_COLOR_TYPE_PALETTE, samples(15, 1, 1))},
          {"PNG in colours", whole_png(8, PNG_COLOR_TYPE_RGB, samples(255, 3, 1))},
          {"PNG in colours of 16 bits", whole_png(16, PNG_COLOR_TYPE_RGB, samples(65535, 3, 2))},
          {"half clear PNG", whole_png(8, PNG_COLOR_TYPE_GRAY_ALPHA, samples(255, 1, 1, clear8))},
          {"half clear PNG in colours of 16 bits",
           whole_png(16, PNG_COLOR_TYPE_RGB_ALPHA, samples(65535, 3, 2, clear16))},
          {"JPEG", jpeg(true, false)},
          {"JPEG in colours", jpeg(false, false)},
          {"progressive JPEG", jpeg(true, true)}};
}

}  // namespace io_test
