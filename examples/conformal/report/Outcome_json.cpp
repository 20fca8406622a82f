// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Outcome.h"

#include <Conformal_geometry_processing/version.h>

#include <nlohmann/json.hpp>

namespace conformal {
namespace {

using Json = nlohmann::ordered_json;

void enter_report(const Report& report, Json& json)
{
  for (const auto& [place, value] : report.entries())
    std::visit([&, &at = place](const auto& v) { json[Json::json_pointer("/" + at)] = v; }, value);
}

void enter_verdict(const Outcome& outcome, Json& json)
{
  if (outcome.verdict) json["verified"] = outcome.verdict->is_verified();
  const std::string error = outcome.error.empty() ? outcome.ending().error : outcome.error;
  if (error.empty()) return;
  json["verified"] = false;
  json["error"] = error;
}

Json json_of(const Component_outcome& component)
{
  Json json = {{"first_vertex", component.first_vertex},
               {"vertices", component.topology.vertices},
               {"faces", component.topology.faces},
               {"boundary_loops", component.topology.boundary_loops},
               {"genus", component.topology.genus}};
  enter_report(component.outcome.report, json);
  enter_verdict(component.outcome, json);
  return json;
}

}  // namespace

std::string to_json(const Outcome& outcome)
{
  Json json = {{"command", outcome.command}, {"version", CONFORMAL_GEOMETRY_PROCESSING_VERSION}};
  const auto parts = {"options", "input", "result", "components", "steps", "seconds"};
  for (const char* part : parts) json[part] = nullptr;  // fixes the order
  enter_report(outcome.report, json);
  for (const Component_outcome& component : outcome.components)
    json["components"].push_back(json_of(component));
  for (const auto& [stage, seconds] : outcome.seconds.stages()) json["seconds"][stage] = seconds;
  enter_verdict(outcome, json);
  json["notes"] = outcome.notes;
  for (const char* part : parts)
    if (json[part].is_null()) json.erase(part);
  // A path need not be UTF-8, but JSON must be.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace conformal
