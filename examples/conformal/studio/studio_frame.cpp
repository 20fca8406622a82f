// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "studio_frame.h"

#include "studio_page_text.h"

#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/read_bytes.h"
#include "conformal/process/Failure.h"

#include <Conformal_geometry_processing/version.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <system_error>

namespace conformal {
namespace {

// Between them are the surfaces, in which every < is escaped.
const std::string data_begin = "<script type=\"application/json\" id=\"studio\">";
const std::string data_end = "\n<script type=\"text/plain\" id=\"three\">";

Read_error no_page(const std::string& path)
{
  return {path, 0, "is not a page of the studio, wanted one that `conformal studio` has written"};
}

std::string version_in(const std::string& json, const std::string& path)
{
  const auto studio = nlohmann::json::parse(json.begin(), json.end(), nullptr, false);
  if (!studio.is_object() || !studio.contains("version") || !studio["version"].is_string())
    throw no_page(path);
  return studio["version"];
}

}  // namespace

std::string installed_studio_page()
{
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path prefix =
      error ? std::filesystem::path(studio_page_prefix) : program.parent_path().parent_path();
  return (prefix / "share" / "conformal" / "studio.html").string();
}

Studio_frame read_studio_frame(const std::string& path)
{
  const std::string page = read_bytes(path, "a page of the studio");
  const std::size_t begin = page.find(data_begin), json = begin + data_begin.size();
  const std::size_t json_end = page.find("</script>", begin), end = page.find(data_end, begin);
  if (begin == std::string::npos || json_end == std::string::npos || end == std::string::npos)
    throw no_page(path);
  return {page.substr(0, begin), page.substr(end),
          version_in(page.substr(json, json_end - json), path)};
}

Studio_frame studio_frame(const std::string& page)
{
  if (!page.empty()) return read_studio_frame(page);
  if (studio_page_begin[0] != '\0')
    return {studio_page_begin, studio_page_end, CONFORMAL_GEOMETRY_PROCESSING_VERSION};
  const std::string installed = installed_studio_page();
  std::error_code error;
  if (std::filesystem::exists(installed, error)) return read_studio_frame(installed);
  throw Failure(
      Exit_code::usage,
      "this program was built without the studio: " + std::string(studio_page_fault) +
          ", and there is no " + installed +
          "; try: --advanced page=FILE with a page that another program has written, or " +
          studio_page_advice);
}

}  // namespace conformal
