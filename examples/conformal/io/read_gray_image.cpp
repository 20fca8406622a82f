// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_gray_image.h"

#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/read_bytes.h"
#include "conformal/io/picture/read_jpeg.h"
#include "conformal/io/picture/read_png.h"
#include "conformal/io/picture/read_pnm.h"

namespace conformal {
namespace {

Picture parse_picture(std::string_view bytes, const std::string& path)
{
  if (starts_with(bytes, "\x89PNG")) return parse_png(bytes, path);
  if (starts_with(bytes, "\xff\xd8\xff")) return parse_jpeg(bytes, path);
  for (const char* magic : {"P2", "P3", "P5", "P6"})
    if (starts_with(bytes, magic)) return parse_pnm(bytes, path);
  throw Read_error(path, 0, "cannot be understood as PNG, JPEG, PGM or PPM picture");
}

}  // namespace

CGP::Gray_image parse_gray_image(std::string_view bytes, const std::string& path)
{
  const Picture picture = parse_picture(bytes, path);
  Eigen::ArrayXXd gray(picture.height(), picture.width());
  for (Eigen::Index row = 0; row < gray.rows(); ++row)
    for (Eigen::Index column = 0; column < gray.cols(); ++column)
      gray(row, column) =
          picture.gray(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
  return CGP::Gray_image(std::move(gray));
}

CGP::Gray_image read_gray_image(const std::string& path)
{
  return parse_gray_image(read_bytes(path, "a picture"), path);
}

}  // namespace conformal
