// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief Many quaternionic vectors of n entries, stored row by row, so that inner products and
/// combinations are products of *real* matrices: for hundreds of vectors, several times faster than
/// one vector at a time.
///
/// Has a capacity; the leading columns are in use.
class Row_major_multivector {
 public:
  using Vectors = Block<Quaternion<double>>;

  Row_major_multivector(Eigen::Index rows, Eigen::Index capacity) : m_numbers(rows, 4 * capacity) {}

  Eigen::Index rows() const { return m_numbers.rows(); }
  Eigen::Index size() const { return m_size; }
  Eigen::Index capacity() const { return m_numbers.cols() / 4; }

  /// \pre the capacity suffices for the columns of v
  void append(const Vectors& v);

  /// \brief Returns V^H w for the columns V from `begin` on, (size() - begin) x w.cols()
  Vectors gram(const Vectors& w, Coefficients coefficients, Eigen::Index begin = 0) const;

  /// \brief Returns V C for the columns V from `begin` on
  Vectors combination(const Vectors& C, Eigen::Index begin = 0) const;

  /// \brief Replaces the columns by their combinations with C, some rows at a time.
  void combine(const Vectors& C);

 private:
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Eigen::Ref<const Numbers> used(Eigen::Index begin = 0) const
  {
    return m_numbers.middleCols(4 * begin, 4 * (m_size - begin));
  }

  static constexpr Eigen::Index part = 256;  // rows that fit the cache

  /// Calls `visit(first, count)` for parts of the rows begin ... end - 1
  template <class Visitor>
  static void for_each_part(Eigen::Index begin, Eigen::Index end, const Visitor& visit)
  {
    for (Eigen::Index first = begin; first < end; first += part)
      visit(first, (std::min)(part, end - first));
  }

  /// \brief The same for all rows, on several threads.
  ///
  /// Parts are the same for any number of threads: the last bits of a product depend on its size.
  template <class Visitor>
  void for_each_part(const Visitor& visit) const
  {
    const std::ptrdiff_t least = 4;
    for_each_range((rows() + part - 1) / part, least,
                   [&](std::ptrdiff_t first, std::ptrdiff_t last) {
                     for_each_part(first * part, (std::min)(last * part, rows()), visit);
                   });
  }

  /// v as real numbers, row by row
  template <class Rows>
  static Numbers numbers(const Rows& v)
  {
    Numbers all(v.rows(), 4 * v.cols());
    for (Eigen::Index j = 0; j < v.cols(); ++j)
      for (Eigen::Index i = 0; i < v.rows(); ++i) {
        const Quaternion<double> q = v(i, j);
        all.template block<1, 4>(i, 4 * j) << q.w, q.x, q.y, q.z;
      }
    return all;
  }

  /// q -> q c for each entry c, as real matrices that act on rows (w, x, y, z)
  static Numbers right_factors(const Vectors& C);

  Numbers m_numbers;
  Eigen::Index m_size = 0;
};

}  // namespace Conformal_geometry_processing::internal
