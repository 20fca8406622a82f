// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Left_out.h"

#include <algorithm>

namespace conformal {

void Left_out::add(std::string_view what, const std::string& where)
{
  constexpr std::size_t most = 10;  // a file that is not a mesh may have any number of kinds
  const auto is_same = [what](const Kind& kind) { return kind.what == what; };
  const auto known = std::find_if(m_kinds.begin(), m_kinds.end(), is_same);
  if (known != m_kinds.end())
    ++known->count;
  else if (m_kinds.size() > most)
    ++m_kinds.back().count;
  else
    m_kinds.push_back({std::string(m_kinds.size() < most ? what : "other things"), where, 1});
}

std::vector<std::string> Left_out::notes() const
{
  std::vector<std::string> notes;
  for (const Kind& kind : m_kinds)
    notes.push_back("left out: " + kind.what +
                    (kind.first.empty()
                         ? ""
                         : " (" + std::to_string(kind.count) + ", first: " + kind.first + ')'));
  return notes;
}

}  // namespace conformal
