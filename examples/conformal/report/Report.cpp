// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Report.h"

#include "conformal/process/text.h"

namespace conformal {

void Report::set(const std::string& place, Value value)
{
  const auto [known, is_new] = m_index.try_emplace(place, m_entries.size());
  if (is_new)
    m_entries.emplace_back(place, std::move(value));
  else
    m_entries[known->second].second = std::move(value);
}

void Report::show(const Grid& grid)
{
  end_table();
  m_text += (m_text.empty() ? "" : "\n") + grid.text();
}

void Report::tell(const std::string& place, const std::string& label, double value, int digits)
{
  set(place, value);
  show(label, text_of(value, digits));
}

void Report::tell(const std::string& place, const std::string& label, int value)
{
  set(place, value);
  show(label, std::to_string(value));
}

void Report::end_table()
{
  m_text = text();
  m_table = Table();
}

std::string Report::text() const
{
  const std::string last = m_table.text();
  return m_text + (m_text.empty() || last.empty() ? "" : "\n") + last;
}

}  // namespace conformal
