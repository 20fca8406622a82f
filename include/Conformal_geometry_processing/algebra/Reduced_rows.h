// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgAlgebra
/// \brief The rows of a quaternionic vector that have two real degrees of freedom instead of four:
/// boundary vertices of a surface with prescribed boundary directions [CGP 5.7].
///
/// Real coordinates are numbered row by row, four or two for each. Depends on the connectivity
/// only; `Reduced_basis` contains the planes of H.
class Reduced_rows {
 public:
  Reduced_rows() = default;

  /// \param size the number of all rows \param reduced the reduced ones, in any order
  /// \throw Precondition_error if an index is not a row, or occurs twice
  Reduced_rows(int size, const std::vector<int>& reduced);

  /// Number of rows
  int size() const { return static_cast<int>(m_is_reduced.size()); }

  int size_of_reduced() const { return m_count; }

  bool is_reduced(int i) const { return m_is_reduced[at(i)] != 0; }

  /// Number of real coordinates
  int dimension() const { return m_first.empty() ? 0 : m_first.back(); }

  /// Number of coordinates of row i, 2 or 4
  int dimension(int i) const { return first(i + 1) - first(i); }

  /// First coordinate of row i
  int first(int i) const { return m_first[at(i)]; }

  friend bool operator==(const Reduced_rows& a, const Reduced_rows& b)
  {
    return a.m_is_reduced == b.m_is_reduced;
  }
  friend bool operator!=(const Reduced_rows& a, const Reduced_rows& b) { return !(a == b); }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  std::vector<char> m_is_reduced;
  std::vector<int> m_first;  // size() + 1
  int m_count = 0;
};

}  // namespace Conformal_geometry_processing::internal
