// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/krylov/Krylov_space.h>

#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing::internal {

Krylov_space::Krylov_space(const Pencil& pencil, Eigen::Index rows, Eigen::Index capacity)
    : m_pencil(pencil),
      m_V(rows, capacity),
      m_projection(Vectors::Constant(capacity, capacity, {})),
      m_next(rows, 0)
{}

void Krylov_space::adopt(const Vectors& eigenvectors, const Vector<double>& theta)
{
  if (theta.size() == 0) return;
  m_V.append(eigenvectors);
  set_projection(theta);
}

void Krylov_space::begin_with(Vectors v)
{
  const double length = longest(v, m_pencil.N(v));
  (void)orthonormalize(std::move(v), rounding * length);
  m_coupled = size();
}

// T v has components in the last blocks, and, after a restart, in all columns before it; what else
// is found of it in V is rounding errors, or those of eigenvectors.
void Krylov_space::extend()
{
  const Eigen::Index first = size(), count = m_next.cols();
  m_V.append(m_next);
  const Vectors image = m_pencil.K(m_next);
  const Vectors coupling = m_V.gram(image, m_pencil.coefficients, m_coupled);
  Vectors w = m_pencil.solve(image);
  const double length = longest(w, image);  // N (N^-1 K v) = K v
  w -= m_V.combination(coupling, m_coupled);
  Vectors column = orthonormalize(std::move(w), rounding * length);
  column.bottomRows(coupling.rows()) += coupling;
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < size(); ++i) {
      m_projection(first + j, i) = conjugate(column(i, j));
      m_projection(i, first + j) = column(i, j);
    }
  m_last = m_coupled = first;
}

Vector<double> Krylov_space::residuals(const Vectors& y) const
{
  Vector<double> norms = Vector<double>::Zero(y.cols());
  if (!has_next()) return norms;
  const Vectors last = y.middleRows(m_last, m_remainder.cols());
  const Vectors r = Conformal_geometry_processing::combination(m_remainder, last);
  for (Eigen::Index j = 0; j < norms.size(); ++j)
    norms[j] = std::sqrt(inner_product(r.col(j), r.col(j)).w);
  return norms;
}

void Krylov_space::restart(const Vectors& y, const Vector<double>& theta)
{
  m_V.combine(y);
  set_projection(theta);
  m_coupled = 0;
}

void Krylov_space::set_projection(const Vector<double>& theta)
{
  for (Eigen::Index j = 0; j < size(); ++j)
    for (Eigen::Index i = 0; i < size(); ++i)
      m_projection(i, j) = {i == j ? theta[j] : 0., 0, 0, 0};
}

double Krylov_space::longest(const Vectors& w, const Vectors& Nw)
{
  double square = 0;
  for (Eigen::Index j = 0; j < w.cols(); ++j) {
    const double next = inner_product(w.col(j), Nw.col(j)).w;
    if (!std::isfinite(next)) throw Solver_error("Krylov_space", "the numbers are not finite");
    square = (std::max)(square, next);
  }
  return std::sqrt(square);
}

Krylov_space::Gram_basis Krylov_space::gram_basis(const Vectors& gram, double least)
{
  const auto pairs = hermitian_eigen_decomposition(gram);
  const Vector<double> lengths = pairs.values.cwiseMax(0).cwiseSqrt();  // ascending
  const Eigen::Index rank = (lengths.array() > least).count(), first = lengths.size() - rank;
  Gram_basis b{pairs.vectors.rightCols(rank), Vectors(rank, gram.cols()),
               rank > 0 ? lengths[first] : std::numeric_limits<double>::infinity()};
  for (Eigen::Index j = 0; j < rank; ++j)
    for (Eigen::Index i = 0; i < gram.cols(); ++i) {
      b.factor(j, i) = conjugate(b.basis(i, j)) * lengths[first + j];
      b.basis(i, j) *= 1 / lengths[first + j];
    }
  return b;
}

// Once more where little was left of w, in which rounding errors would be large.
auto Krylov_space::orthonormalize(Vectors w, double lost) -> Vectors
{
  const double little = 0.01, of_unit_vectors = 0.5;
  Vectors along_V = Vectors::Constant(size(), w.cols(), {});
  m_remainder = Vectors::Constant(w.cols(), w.cols(), {});
  for (Eigen::Index j = 0; j < w.cols(); ++j) m_remainder(j, j).w = 1;
  for (bool is_exact = false; !is_exact; lost = of_unit_vectors) {
    const Vectors Nw = m_pencil.N(w), now = m_V.gram(Nw, m_pencil.coefficients);
    const double before = longest(w, Nw);
    add_combination(along_V, now, m_remainder);
    w -= m_V.combination(now);
    const Gram_basis b = gram_basis(gram_matrix(w, m_pencil.N(w), m_pencil.coefficients), lost);
    w = Conformal_geometry_processing::combination(w, b.basis);
    m_remainder = Conformal_geometry_processing::combination(b.factor, m_remainder);
    is_exact = b.shortest >= little * before;
  }
  m_next = std::move(w);
  return along_V;
}

}  // namespace Conformal_geometry_processing::internal
