// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_KRYLOV_SPACE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_KRYLOV_SPACE_H

#include <Conformal_geometry_processing/linear_algebra/dense/quaternionic_householder.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Row_panel.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the operator T = N^-1 K of a pencil K x = theta N x, with N positive definite:
/// self-adjoint in the inner product of N.
///
/// Each maps some vectors at once. On a space that `solve` projects to, K and N may be any that
/// agree with them there.
struct Pencil {
  using Operator = std::function<Block<Quaternion<double>>(const Block<Quaternion<double>>&)>;

  Operator K, N, solve;  ///< Hermitian; Hermitian positive definite; b -> N^-1 b
  Coefficients coefficients = Coefficients::quaternions;
};

namespace internal {

/// An N-orthonormal basis V of a Krylov space of T, with V^H K V, and the block that follows:
/// T V = V (V^H K V) + next * remainder * E^H, where E are the columns of the last block.
class Krylov_space {
  using Vectors = Block<Quaternion<double>>;

 public:
  /// \pre room for more columns than one block
  Krylov_space(const Pencil& pencil, Eigen::Index rows, Eigen::Index capacity)
      : m_pencil(pencil),
        m_V(rows, capacity),
        m_NV(rows, capacity),
        m_projection(Vectors::Constant(capacity, capacity, {})),
        m_next(rows, 0)
  {}

  Eigen::Index size() const { return m_V.size(); }
  bool has_next() const { return m_next.cols() > 0; }
  bool has_room() const { return size() + m_next.cols() <= m_V.capacity(); }
  Eigen::Index rows() const { return m_V.rows(); }

  /// \brief continues with other vectors: with what is left of them outside of the span of V.
  /// \pre V is empty, or its columns are eigenvectors
  void begin_with(Block<Quaternion<double>> v) { orthonormalize(std::move(v)); }

  /// \brief takes the next block in, and finds the one after it: one product with K and one
  /// solution for each of its columns.
  /// \pre has_next() and has_room()
  void extend()
  {
    const Eigen::Index first = size(), count = m_next.cols();
    m_V.append(m_next);
    m_NV.append(m_pencil.N(m_next));
    const Vectors image = m_pencil.K(m_next);
    const Vectors column = m_V.gram(image, m_pencil.coefficients);
    for (Eigen::Index j = 0; j < count; ++j)
      for (Eigen::Index i = 0; i < size(); ++i) {
        m_projection(first + j, i) = conjugate(column(i, j));
        m_projection(i, first + j) = column(i, j);
      }
    m_last = first;
    orthonormalize(m_pencil.solve(image));
  }

  /// V^H K V
  Vectors projection() const { return m_projection.topLeftCorner(size(), size()); }

  /// \brief the norms of T V y - V y theta for the eigenpairs of the projection.
  Vector<double> residuals(const Vectors& y) const
  {
    Vector<double> norms = Vector<double>::Zero(y.cols());
    if (!has_next()) return norms;
    const Vectors last = y.middleRows(m_last, m_remainder.cols());
    const Vectors r = Conformal_geometry_processing::combination(m_remainder, last);
    for (Eigen::Index j = 0; j < norms.size(); ++j)
      norms[j] = std::sqrt(inner_product(r.col(j), r.col(j)).w);
    return norms;
  }

  /// \brief replaces V by V y; the next block stays, and T V lies in their span as before.
  /// \param y eigenvectors of the projection \param theta its eigenvalues
  void restart(const Vectors& y, const Vector<double>& theta)
  {
    m_V.combine(y);
    m_NV.combine(y);
    for (Eigen::Index j = 0; j < size(); ++j)
      for (Eigen::Index i = 0; i < size(); ++i)
        m_projection(i, j) = {i == j ? theta[j] : 0., 0, 0, 0};
  }

  /// V y
  Vectors combination(const Vectors& y) const { return m_V.combination(y); }

 private:
  /// Makes `m_next` an N-orthonormal basis of what w adds to the span of V, and `m_remainder` such
  /// that w = V * something + next * remainder.
  void orthonormalize(Vectors w)
  {
    const double lost = 1e-10;  // of the length of the longest column: mostly rounding errors
    double longest = 0;
    for (int pass = 0; pass < 2; ++pass) {
      const Vectors Nw = m_pencil.N(w);
      const Vectors before = gram_matrix(w, Nw, m_pencil.coefficients);
      for (Eigen::Index j = 0; pass == 0 && j < w.cols(); ++j)
        longest = (std::max)(longest, std::sqrt((std::max)(before(j, j).w, 0.)));
      if (size() > 0) w -= m_V.combination(m_NV.gram(w, m_pencil.coefficients));
      const auto gram = hermitian_jacobi(gram_matrix(w, m_pencil.N(w), m_pencil.coefficients));
      Eigen::Index rank = 0;
      while (rank < w.cols() && std::sqrt((std::max)(gram.values[w.cols() - 1 - rank], 0.)) >
                                    (pass == 0 ? lost * longest : 0.5))
        ++rank;
      Vectors basis = gram.vectors.rightCols(rank), R(rank, w.cols());
      for (Eigen::Index j = 0; j < rank; ++j) {
        const double length = std::sqrt(gram.values[w.cols() - rank + j]);
        for (Eigen::Index i = 0; i < basis.rows(); ++i) {
          R(j, i) = conjugate(basis(i, j)) * length;
          basis(i, j) *= 1 / length;
        }
      }
      w = Conformal_geometry_processing::combination(w, basis);
      m_remainder = pass == 0 ? R : Conformal_geometry_processing::combination(R, m_remainder);
    }
    m_next = std::move(w);
  }

  const Pencil& m_pencil;
  Row_panel m_V, m_NV;
  Vectors m_projection;  // capacity x capacity
  Vectors m_next, m_remainder;
  Eigen::Index m_last = 0;  // the first column of the last block
};

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
