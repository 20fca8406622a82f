// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Report.h"

#include <algorithm>

namespace conformal {

void Report::set(const std::string& place, Value value)
{
  const auto known = std::find_if(m_entries.begin(), m_entries.end(),
                                  [&](const auto& entry) { return entry.first == place; });
  if (known != m_entries.end())
    known->second = std::move(value);
  else
    m_entries.emplace_back(place, std::move(value));
}

void Report::add_seconds(const std::string& stage, double seconds)
{
  const std::string place = "seconds/" + stage;
  for (const auto& [name, value] : m_entries)
    if (name == place) seconds += std::get<double>(value);
  set(place, seconds);
}

}  // namespace conformal
