// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Report.h"

#include <utility>

namespace conformal {

void Report::set(const std::string& place, Value value)
{
  const auto [known, is_new] = m_index.try_emplace(place, m_entries.size());
  if (is_new)
    m_entries.emplace_back(place, std::move(value));
  else
    m_entries[known->second].second = std::move(value);
}

void Report::add_seconds(const std::string& stage, double seconds)
{
  const std::string place = "seconds/" + stage;
  const auto known = m_index.find(place);
  if (known != m_index.end()) seconds += std::get<double>(m_entries[known->second].second);
  set(place, seconds);
}

}  // namespace conformal
