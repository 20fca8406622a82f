// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Report.h"

#include <nlohmann/json.hpp>

namespace conformal {

std::string to_json(const Report& report)
{
  using Json = nlohmann::ordered_json;
  Json json = Json::object();
  const auto parts = {"command", "version", "input", "result", "components", "steps", "seconds"};
  for (const char* part : parts) json[part] = nullptr;  // fixes the order
  for (const auto& [place, value] : report.entries())
    std::visit([&, &at = place](const auto& v) { json[Json::json_pointer("/" + at)] = v; }, value);
  for (const char* part : parts)
    if (json[part].is_null()) json.erase(part);
  // A path need not be UTF-8, but JSON must be.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace conformal
