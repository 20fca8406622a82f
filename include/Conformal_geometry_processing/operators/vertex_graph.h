// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief the pattern of every Hermitian matrix on the vertices of a surface, |V| x |V|: the
/// diagonal, and one entry for each pair of different vertices that an edge joins.
std::shared_ptr<const Sparse_pattern> vertex_graph(const Surface_ref& surface);

/// the position of the diagonal entry (i, i) in a `vertex_graph()`
inline int diagonal_position(const Sparse_pattern& pattern, int i)
{
  return pattern.offsets[static_cast<std::size_t>(i)];
}

namespace internal {

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

/// Calls `add(sheet)` for all sheets with `concerns(sheet)`, in their order
template <class Concerns, class Add>
void for_each_sheet_if(const Surface_ref& surface, const Concerns& concerns, const Add& add)
{
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    if (concerns(sheet)) add(sheet);
  }
}

/// Calls `add(sheet)` for all sheets with a corner in the range, in their order
template <class Add>
void for_each_sheet_at(const Index_range& own, const Surface_ref& surface, const Add& add)
{
  for_each_sheet_if(
      surface, [&](const Sheet& sheet) { return own.touches(sheet); }, add);
}

/// \brief Returns the sum of what `add(sheet, sum)` adds to `zero`, over all sheets, or those that
/// a part counts, on several threads; the same bits for any number.
template <class Sum, class Add>
Sum sum_over_sheets(const Surface_ref& surface, const Sum& zero, const Add& add,
                    const Surface_part& part = {})
{
  const std::ptrdiff_t at_once = 2048;
  const auto add_range = [&](std::ptrdiff_t first, std::ptrdiff_t last, Sum& sum) {
    for (std::ptrdiff_t s = first; s < last; ++s) add(surface.sheet(static_cast<int>(s)), sum);
  };
  return sum_of_ranges(part.own_faces(surface.size_of_sheets()), at_once, zero, add_range);
}

/// \brief the position of entry (row, column) in a `vertex_graph()`, row > column.
///
/// A `Mesh_view` numbers its edges in the order of the pattern, so the position is that of the
/// edge, behind one diagonal for each column so far. The edges of other surfaces are searched for.
inline int entry_position(const Sparse_pattern& pattern, int row, int column, int edge)
{
  const int* const offsets = pattern.offsets.data() + column;
  const int k = edge + column + 1;
  const bool is_there = offsets[0] < k && k < offsets[1] && pattern.indices.data()[k] == row;
  return is_there ? k : pattern.find(row, column);
}

/// \brief adds the contribution of a sheet to the columns of some vertices in a matrix.
/// \param A on `vertex_graph()` of the surface
/// \param entry the value for corners (i, i) and (i, i + 1), Hermitian: that for (i + 1, i) is the
/// conjugate
template <class Scalar, class Entry>
void add_sheet(const Sheet& sheet, const Index_range& own, Entry entry,
               Hermitian_sparse_matrix<Scalar>& A)
{
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, from = sheet.corners[static_cast<std::size_t>(i)],
              to = sheet.corners[static_cast<std::size_t>(j)];
    const Scalar forward = entry(i, j), backward = conjugate(forward);
    if (own.contains(from)) {
      Scalar& diagonal = A.value(diagonal_position(A.pattern(), from));
      diagonal += entry(i, i);
      if (from == to) diagonal += forward + backward;
    }
    const auto [column, row] = std::minmax(from, to);
    if (from == to || !own.contains(column)) continue;
    const int edge = sheet.edges[static_cast<std::size_t>(3 - i - j)];
    A.value(entry_position(A.pattern(), row, column, edge)) += from > to ? forward : backward;
  }
}

/// \brief sets A to the sum of what `add(sheet, own)` adds to the columns of the vertices in
/// `own`, over all sheets that touch these.
template <class Scalar, class Add>
void assemble_sheets(const Surface_ref& surface, Hermitian_sparse_matrix<Scalar>& A, const Add& add)
{
  for_each_owned_range(A.size(), [&](const Index_range& own) {
    A.set_zero(own.first, own.last);
    for_each_sheet_at(own, surface, [&](const Sheet& sheet) { add(sheet, own); });
  });
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
