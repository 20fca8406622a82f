// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_REDUCED_ROWS_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_REDUCED_ROWS_H

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief which rows of a quaternionic vector have two real degrees of freedom and not four: the
/// boundary vertices of a surface whose boundary directions are prescribed [CGP 5.7].
///
/// Real coordinates are numbered row by row, four or two for each. Depends on the connectivity
/// alone; in which plane of H a row lies is told by `Reduced_basis`.
class Reduced_rows {
 public:
  Reduced_rows() = default;

  /// \param size the number of all rows \param reduced the reduced ones, in any order
  /// \throw Precondition_error where a number is not a row, or comes twice
  Reduced_rows(int size, const std::vector<int>& reduced);

  /// the number of rows
  int size() const { return static_cast<int>(m_is_reduced.size()); }

  int size_of_reduced() const { return m_count; }

  bool is_reduced(int i) const { return m_is_reduced[at(i)] != 0; }

  /// the number of real coordinates
  int dimension() const { return m_first.empty() ? 0 : m_first.back(); }

  /// the number of coordinates of row i, 2 or 4
  int dimension(int i) const { return first(i + 1) - first(i); }

  /// the first coordinate of row i
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

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/algebra/Reduced_rows_impl.h>
#endif

#endif
