// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "page_blocks.h"

#include "conformal/io/file/io_errors.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace conformal {

std::string page_block(const std::string& name, const std::string& type, const std::string& content)
{
  return "<script type=\"" + type + "\" id=\"" + name + "\">" + content + "</script>\n";
}

std::string faces_block(const std::string& name, const CGP::Mesh_view& mesh)
{
  std::vector<int> corners;
  for (const auto& face : mesh.corners()) corners.insert(corners.end(), face.begin(), face.end());
  return numbers_block<std::uint32_t>(name, corners);
}

// In JSON a < is in a string.
std::string json_block(const std::string& name, const std::string& json)
{
  std::string text;
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return page_block(name, "application/json", text);
}

void require_page_name(const std::string& path)
{
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".html" && extension != ".htm")
    throw Write_error(path, "is not a name for an HTML report, wanted .html");
}

}  // namespace conformal
