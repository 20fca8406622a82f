// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/Krylov_space.h>

#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

void internal::Row_major_multivector::append(const Vectors& v)
{
  const auto set = [&](Eigen::Index first, Eigen::Index count) {
    m_numbers.block(first, 4 * m_size, count, 4 * v.cols()) = numbers(v.middleRows(first, count));
  };
  for_each_part(set);
  m_size += v.cols();
}

internal::Row_major_multivector::Vectors internal::Row_major_multivector::gram(
    const Vectors& w, internal::Coefficients coefficients, Eigen::Index begin_of_columns) const
{
  const Eigen::Ref<const Numbers> V = used(begin_of_columns);
  const Eigen::Index at_once = 16 * part;  // a sum for each
  const auto add = [&](Eigen::Index begin, Eigen::Index end, Numbers& sum) {
    for_each_part(begin, end, [&](Eigen::Index first, Eigen::Index count) {
      sum.noalias() += V.middleRows(first, count).transpose() * numbers(w.middleRows(first, count));
    });
  };
  const Numbers zero = Numbers::Zero(V.cols(), 4 * w.cols());
  const Numbers products = sum_of_ranges(rows(), at_once, zero, add);
  Vectors G(V.cols() / 4, w.cols());
  for (Eigen::Index j = 0; j < G.cols(); ++j)
    for (Eigen::Index i = 0; i < G.rows(); ++i) {
      const Eigen::Matrix4d p = products.block<4, 4>(4 * i, 4 * j);
      const Quaternion<double> q{
          p(0, 0) + p(1, 1) + p(2, 2) + p(3, 3), p(0, 1) - p(1, 0) - p(2, 3) + p(3, 2),
          p(0, 2) + p(1, 3) - p(2, 0) - p(3, 1), p(0, 3) - p(1, 2) + p(2, 1) - p(3, 0)};
      G(i, j) = reduced_to(coefficients, q);
    }
  return G;
}

internal::Row_major_multivector::Vectors internal::Row_major_multivector::combination(
    const Vectors& C, Eigen::Index begin_of_columns) const
{
  const Eigen::Ref<const Numbers> V = used(begin_of_columns);
  const Numbers factors = right_factors(C);
  Vectors v(rows(), C.cols());
  const auto set = [&](Eigen::Index first, Eigen::Index count) {
    const Numbers products = V.middleRows(first, count) * factors;
    for (Eigen::Index j = 0; j < v.cols(); ++j)
      for (Eigen::Index i = 0; i < count; ++i)
        v(first + i, j) = {products(i, 4 * j), products(i, 4 * j + 1), products(i, 4 * j + 2),
                           products(i, 4 * j + 3)};
  };
  for_each_part(set);
  return v;
}

void internal::Row_major_multivector::combine(const Vectors& C)
{
  const Numbers factors = right_factors(C);
  const auto replace = [&](Eigen::Index first, Eigen::Index count) {
    const Numbers products = used().middleRows(first, count) * factors;
    m_numbers.block(first, 0, count, products.cols()) = products;
  };
  for_each_part(replace);
  m_size = C.cols();
}

internal::Row_major_multivector::Numbers internal::Row_major_multivector::right_factors(
    const Vectors& C)
{
  Numbers factors(4 * C.rows(), 4 * C.cols());
  for (Eigen::Index i = 0; i < C.rows(); ++i)
    for (Eigen::Index j = 0; j < C.cols(); ++j) {
      const Quaternion<double> c = C(i, j);
      factors.block<4, 4>(4 * i, 4 * j) << c.w, c.x, c.y, c.z,  //
          -c.x, c.w, -c.z, c.y,                                 //
          -c.y, c.z, c.w, -c.x,                                 //
          -c.z, -c.y, c.x, c.w;
    }
  return factors;
}

namespace internal {

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

}  // namespace internal
}  // namespace Conformal_geometry_processing
