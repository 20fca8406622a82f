// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/file/base64.h"
#include "conformal/io/file/little_endian.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// a block of data for the scripts of a page
/// \param content must not contain `</script`
std::string page_block(const std::string& name, const std::string& type,
                       const std::string& content);

/// numbers as little endian bytes in base64
template <class Number, class Values>
std::string numbers_block(const std::string& name, const Values& values)
{
  std::string bytes;
  for (const auto value : values) append_little_endian(bytes, static_cast<Number>(value));
  return page_block(name, "text/plain", base64(bytes));
}

/// the corners of the faces, uint32, 3 per face
std::string faces_block(const std::string& name, const CGP::Mesh_view& mesh);

/// JSON, escaped so that it can neither end the block nor begin a comment
std::string json_block(const std::string& name, const std::string& json);

/// Requires an extension, so that a page does not overwrite a mesh. \throws Write_error
void require_page_name(const std::string& path);

}  // namespace conformal
