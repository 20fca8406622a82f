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
      m_NV(rows, capacity),
      m_projection(Vectors::Constant(capacity, capacity, {})),
      m_next(rows, 0)
{}

CGP_INLINE void Krylov_space::adopt(const Vectors& eigenvectors, const Vector<double>& theta)
{
  if (theta.size() == 0) return;
  m_V.append(eigenvectors);
  m_NV.append(m_pencil.N(eigenvectors));
  set_projection(theta);
}

CGP_INLINE void Krylov_space::extend()
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
  m_NV.combine(y);
  set_projection(theta);
}

CGP_INLINE void Krylov_space::set_projection(const Vector<double>& theta)
{
  for (Eigen::Index j = 0; j < size(); ++j)
    for (Eigen::Index i = 0; i < size(); ++i)
      m_projection(i, j) = {i == j ? theta[j] : 0., 0, 0, 0};
}

CGP_INLINE void Krylov_space::orthonormalize(Vectors w)
{
  const double lost = 1e-10;  // relative to the longest column: below it, mostly rounding errors
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

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
