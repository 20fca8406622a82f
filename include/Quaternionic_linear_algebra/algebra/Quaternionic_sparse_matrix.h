// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <array>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief A |F| x |V| quaternionic matrix with three entries per row: an operator that maps values
/// at vertices to values on triangles [CGP 5.1].
///
/// Its pattern is the list of corners of the triangles, fixed at construction; assembly writes to
/// `value(f, c)`, the entry in row f and in the column of corner c. Right-linear: A (x q) = (A x)
/// q.
template <class FT_>
class Quaternionic_sparse_matrix {
 public:
  using FT = FT_;
  using Corners = std::vector<std::array<int, 3>>;

  /// The zero matrix
  /// \param corners the three columns of each row; must outlive the matrix
  /// \param columns the number of columns, greater than every entry of `corners`
  Quaternionic_sparse_matrix(const Corners& corners, int columns)
      : m_corners(&corners), m_columns(columns), m_values(3 * corners.size())
  {}

  int rows() const { return static_cast<int>(m_corners->size()); }
  int cols() const { return m_columns; }

  /// The column of entry c of row f
  int column(int f, int c) const
  {
    return (*m_corners)[static_cast<std::size_t>(f)][static_cast<std::size_t>(c)];
  }

  Quaternion<FT>& value(int f, int c) { return m_values[position(f, c)]; }
  const Quaternion<FT>& value(int f, int c) const { return m_values[position(f, c)]; }

  /// A x: maps |V| to |F| quaternions
  Quaternion_vector<FT> operator*(const Quaternion_vector<FT>& x) const
  {
    Quaternion_vector<FT> y(rows());
    for (int f = 0; f < rows(); ++f)
      for (int c = 0; c < 3; ++c) y[f] += value(f, c) * x[column(f, c)];
    return y;
  }

  /// A^H y, with the conjugate transpose: maps |F| to |V| quaternions
  Quaternion_vector<FT> adjoint_times(const Quaternion_vector<FT>& y) const
  {
    Quaternion_vector<FT> x(cols());
    for (int f = 0; f < rows(); ++f)
      for (int c = 0; c < 3; ++c) x[column(f, c)] += conjugate(value(f, c)) * y[f];
    return x;
  }

  /// The difference of two matrices with the same corners
  friend Quaternionic_sparse_matrix operator-(Quaternionic_sparse_matrix a,
                                              const Quaternionic_sparse_matrix& b)
  {
    for (std::size_t k = 0; k < a.m_values.size(); ++k) a.m_values[k] -= b.m_values[k];
    return a;
  }

 private:
  static std::size_t position(int f, int c)
  {
    return 3 * static_cast<std::size_t>(f) + static_cast<std::size_t>(c);
  }

  const Corners* m_corners;
  int m_columns;
  std::vector<Quaternion<FT>> m_values;
};

}  // namespace Conformal_geometry_processing::internal
