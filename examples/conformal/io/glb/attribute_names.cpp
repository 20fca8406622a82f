// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "attribute_names.h"

#include "conformal/io/file/checked_bytes.h"

#include <algorithm>
#include <cctype>

namespace conformal {
namespace {

bool is_lower(char c)
{
  return std::islower(static_cast<unsigned char>(c)) != 0;
}

// Words that need no escapes in JSON, and are not coordinates.
bool is_word(const std::string& name)
{
  const auto is_plain = [](char c) { return c > ' ' && c <= '~' && c != '"' && c != '\\'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), is_plain) && name != "x" &&
         name != "y" && name != "z";
}

}  // namespace

std::optional<std::string> property_of(const std::string& attribute)
{
  if (attribute.substr(0, 1) != "_") return {};
  const bool is_mixed = std::any_of(attribute.begin(), attribute.end(), is_lower);
  const std::string name = is_mixed ? attribute.substr(1) : lower(attribute.substr(1));
  return is_word(name) ? std::optional(name) : std::nullopt;
}

std::optional<std::string> attribute_of(const std::string& property)
{
  std::string capitals = "_" + property;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const std::string& attribute : {capitals, "_" + property})
    if (property_of(attribute) == property) return attribute;
  return {};
}

}  // namespace conformal
