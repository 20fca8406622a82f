// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_KRYLOV_SPACE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_KRYLOV_SPACE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Krylov_space.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Krylov_space::Krylov_space(const Pencil& pencil, Eigen::Index rows,
                                      Eigen::Index capacity)
    : m_pencil(pencil),
      m_V(rows, capacity),
      m_projection(Vectors::Constant(capacity, capacity, {})),
      m_next(rows, 0)
{}

CGP_INLINE void Krylov_space::adopt(const Vectors& eigenvectors, const Vector<double>& theta)
{
  if (theta.size() == 0) return;
  m_V.append(eigenvectors);
  set_projection(theta);
}

CGP_INLINE void Krylov_space::begin_with(Vectors v)
{
  Vectors components = along_V(v);
  orthonormalize(std::move(v), std::move(components));
}

CGP_INLINE void Krylov_space::extend()
{
  const Eigen::Index first = size(), count = m_next.cols();
  m_V.append(m_next);
  const Vectors image = m_pencil.K(m_next);
  Vectors column = m_V.gram(image, m_pencil.coefficients);
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < size(); ++i) {
      m_projection(first + j, i) = conjugate(column(i, j));
      m_projection(i, first + j) = column(i, j);
    }
  m_last = first;
  orthonormalize(m_pencil.solve(image), std::move(column));  // V^H N (N^-1 K v)
}

CGP_INLINE Vector<double> Krylov_space::residuals(const Vectors& y) const
{
  Vector<double> norms = Vector<double>::Zero(y.cols());
  if (!has_next()) return norms;
  const Vectors last = y.middleRows(m_last, m_remainder.cols());
  const Vectors r = Conformal_geometry_processing::combination(m_remainder, last);
  for (Eigen::Index j = 0; j < norms.size(); ++j)
    norms[j] = std::sqrt(inner_product(r.col(j), r.col(j)).w);
  return norms;
}

CGP_INLINE void Krylov_space::restart(const Vectors& y, const Vector<double>& theta)
{
  m_V.combine(y);
  set_projection(theta);
}

CGP_INLINE void Krylov_space::set_projection(const Vector<double>& theta)
{
  for (Eigen::Index j = 0; j < size(); ++j)
    for (Eigen::Index i = 0; i < size(); ++i)
      m_projection(i, j) = {i == j ? theta[j] : 0., 0, 0, 0};
}

CGP_INLINE double Krylov_space::longest(const Vectors& w) const
{
  const Vectors Nw = m_pencil.N(w);
  double square = 0;
  for (Eigen::Index j = 0; j < w.cols(); ++j)
    square = (std::max)(square, inner_product(w.col(j), Nw.col(j)).w);
  return std::sqrt(square);
}

CGP_INLINE void Krylov_space::orthonormalize(Vectors w, Vectors along_V)
{
  const double lost = 1e-10 * longest(w);  // below it, mostly rounding errors
  for (int pass = 0; pass < 2; ++pass) {
    if (pass > 0) along_V = this->along_V(w);
    if (size() > 0) w -= m_V.combination(along_V);
    const auto gram = hermitian_jacobi(gram_matrix(w, m_pencil.N(w), m_pencil.coefficients));
    Eigen::Index rank = 0;
    while (rank < w.cols() &&
           std::sqrt((std::max)(gram.values[w.cols() - 1 - rank], 0.)) > (pass == 0 ? lost : 0.5))
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

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
