// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Property.h"

#include <utility>
#include <vector>

namespace conformal {

/// \brief The element with the given rows only, in this order, bit for bit; a row may come twice.
inline Element selected_rows(const Element& element, const std::vector<int>& rows)
{
  Element result{element.name, rows.size(), {}};
  for (const Property& all : element.properties) {
    Property some = all.is_list() ? Property(all.name(), all.count_type(), all.type())
                                  : Property(all.name(), all.type());
    for (const int r : rows) {
      const auto row = static_cast<std::size_t>(r);
      for (std::size_t i = 0; i < all.count(row); ++i)
        some.append_bytes(all.bytes(all.first(row) + i), false);
      if (all.is_list()) some.end_list();
    }
    result.properties.push_back(std::move(some));
  }
  return result;
}

}  // namespace conformal
