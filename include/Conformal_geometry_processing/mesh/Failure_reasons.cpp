// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Failure_reasons.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace Conformal_geometry_processing {

void internal::Failure_reasons::add(const std::string& name, const std::string& reason)
{
  ++m_size;
  auto group = std::find_if(m_groups.begin(), m_groups.end(),
                            [&](const Group& known) { return known.reason == reason; });
  if (group == m_groups.end()) {
    if (m_groups.size() == max_reasons) return;
    group = m_groups.insert(group, {reason, "", 0});
  }
  if (group->size > 0 && group->size < max_names) group->names += ", ";
  if (group->size++ < max_names) group->names += name;
}

std::string internal::Failure_reasons::text() const
{
  std::string text;
  std::size_t told = 0;
  for (const Group& group : m_groups) {
    if (told > 0) text += "; ";
    told += group.size;
    text += group.names;
    if (group.size > max_names) text += " and " + more(group.size - max_names);
    text += ": " + group.reason;
  }
  if (told < m_size) text += "; " + more(m_size - told) + " for other reasons";
  return text;
}

}  // namespace Conformal_geometry_processing
