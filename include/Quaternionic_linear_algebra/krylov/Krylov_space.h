// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace Conformal_geometry_processing::internal {

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

/// \brief The operator T = N^-1 K of a pencil K x = theta N x, with N positive definite:
/// self-adjoint in the inner product of N.
///
/// Each operator maps blocks of vectors. If `solve` projects to a subspace, K and N may be any
/// operators that agree with those of the pencil on it.
struct Pencil {
  using Operator = std::function<Block<Quaternion<double>>(const Block<Quaternion<double>>&)>;

  Operator K, N, solve;  ///< Hermitian; Hermitian positive definite; b -> N^-1 b
  Coefficients coefficients = Coefficients::quaternions;
};

/// An N-orthonormal basis V of a Krylov space of T, with V^H K V, and the next block:
/// T V = V (V^H K V) + next * remainder * E^H, where E are the columns of the last block.
class Krylov_space {
  using Vectors = Block<Quaternion<double>>;

 public:
  /// \pre the capacity exceeds one block
  Krylov_space(const Pencil& pencil, Eigen::Index rows, Eigen::Index capacity);

  Eigen::Index size() const { return m_V.size(); }
  Eigen::Index capacity() const { return m_V.capacity(); }
  bool has_next() const { return m_next.cols() > 0; }
  bool has_room() const { return size() + m_next.cols() <= m_V.capacity(); }
  Eigen::Index size_of_next() const { return m_next.cols(); }
  Eigen::Index rows() const { return m_V.rows(); }

  /// \brief Takes over eigenvectors, N-orthonormal, without computing their images.
  /// \pre V is empty, and there is room for them
  void adopt(const Vectors& eigenvectors, const Vector<double>& theta);

  /// \brief Continues with other vectors, after orthogonalization against V.
  /// \pre V is empty, or its columns are eigenvectors
  void begin_with(Vectors v);

  /// \brief Appends the next block and computes the one after it: one product with K and one
  /// solution for each of its columns.
  /// \pre has_next() and has_room()
  void extend();

  /// V^H K V
  Vectors projection() const { return m_projection.topLeftCorner(size(), size()); }

  /// \brief Returns the norms of T V y - V y theta for the eigenpairs of the projection.
  Vector<double> residuals(const Vectors& y) const;

  /// \brief Replaces V by V y; the next block stays, and T V lies in their span as before.
  /// \param y eigenvectors of the projection \param theta its eigenvalues
  void restart(const Vectors& y, const Vector<double>& theta);

  /// V y
  Vectors combination(const Vectors& y) const { return m_V.combination(y); }

 private:
  /// Sets the projection on eigenvectors
  void set_projection(const Vector<double>& theta);

  static constexpr double rounding = 1e-10;  // less of a vector is mostly rounding errors

  /// w = (w basis) factor, up to what was left out, where w basis is orthonormal; and the length of
  /// the shortest vector that it was made of
  struct Gram_basis {
    Vectors basis, factor;
    double shortest;
  };

  /// \param gram of w
  /// \param least shorter combinations are left out
  static Gram_basis gram_basis(const Vectors& gram, double least);

  /// of the norms of the columns of w by N
  /// \throw Solver_error if they are not finite
  static double longest(const Vectors& w, const Vectors& Nw);

  /// Sets `m_next` to an N-orthonormal basis of the components of w orthogonal to V, and
  /// `m_remainder` such that w = V c + next * remainder.
  /// \param lost the length below which columns are mostly rounding errors
  /// \return c
  Vectors orthonormalize(Vectors w, double lost);

  const Pencil& m_pencil;
  Row_major_multivector m_V;
  Vectors m_projection;  // capacity x capacity
  Vectors m_next, m_remainder;
  // The first columns of the last block, and of those in which T of the next one has components
  Eigen::Index m_last = 0, m_coupled = 0;
};

}  // namespace Conformal_geometry_processing::internal
