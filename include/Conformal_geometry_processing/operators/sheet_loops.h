// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/threads/parallel_loops.h>

#include <cstddef>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgOperators
/// first <= i < last
struct Index_range {
  int first, last;

  bool contains(int i) const { return first <= i && i < last; }

  /// whether it contains the number of a corner of the `Sheet`
  template <class Triangle>
  bool touches(const Triangle& sheet) const
  {
    return contains(sheet.corners[0]) || contains(sheet.corners[1]) || contains(sheet.corners[2]);
  }
};

/// \ingroup PkgOperators
/// \brief Calls `visit(own)` on several threads, with ranges of vertices, or of faces, that make up
/// all: each call sums up, over the sheets that concern its range, what belongs to this.
///
/// Sums have the terms of a plain loop over sheets in the same order, and so the same bits. What
/// concerns several ranges is computed for each, so that there is one range for each thread.
template <class Visitor>
void for_each_owned_range(int count, const Visitor& visit)
{
  const std::ptrdiff_t least = 1000;
  for_each_range(
      count, least,
      [&](std::ptrdiff_t first, std::ptrdiff_t last) {
        visit(Index_range{static_cast<int>(first), static_cast<int>(last)});
      },
      1);
}

/// \ingroup PkgOperators
/// Calls `add(sheet)` for all sheets with `concerns(sheet)`, in their order
template <class Concerns, class Add>
void for_each_sheet_if(const Surface_ref& surface, const Concerns& concerns, const Add& add)
{
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    if (concerns(sheet)) add(sheet);
  }
}

/// \ingroup PkgOperators
/// Calls `add(sheet)` for all sheets with a corner in the range, in their order
template <class Add>
void for_each_sheet_at(const Index_range& own, const Surface_ref& surface, const Add& add)
{
  for_each_sheet_if(
      surface, [&](const Sheet& sheet) { return own.touches(sheet); }, add);
}

/// \ingroup PkgOperators
/// \brief Returns the sum of what `add(sheet, sum)` adds to `zero`, over all sheets, on several
/// threads; the same bits for any number.
template <class Sum, class Add>
Sum sum_over_sheets(const Surface_ref& surface, const Sum& zero, const Add& add)
{
  const std::ptrdiff_t at_once = 2048;
  const auto add_range = [&](std::ptrdiff_t first, std::ptrdiff_t last, Sum& sum) {
    for (std::ptrdiff_t s = first; s < last; ++s) add(surface.sheet(static_cast<int>(s)), sum);
  };
  return sum_of_ranges(surface.size_of_sheets(), at_once, zero, add_range);
}

}  // namespace Conformal_geometry_processing::internal
