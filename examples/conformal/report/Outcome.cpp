// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Outcome.h"

#include <algorithm>

namespace conformal {

void Stage_seconds::add(const std::string& stage, double seconds)
{
  const auto is_same = [&](const auto& known) { return known.first == stage; };
  const auto known = std::find_if(m_stages.begin(), m_stages.end(), is_same);
  if (known == m_stages.end())
    m_stages.emplace_back(stage, seconds);
  else
    known->second += seconds;
}

void Stage_seconds::add(const Stage_seconds& other)
{
  for (const auto& [stage, seconds] : other.stages()) add(stage, seconds);
}

Ending Outcome::ending() const
{
  if (!verdict || verdict->is_verified() || verdict->is_forced) return {};
  return {Exit_code::failed, verdict->fault};
}

}  // namespace conformal
