// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_ROW_MAJOR_MULTIVECTOR_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_ROW_MAJOR_MULTIVECTOR_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Row_major_multivector.h>

#include <Eigen/Core>

#include <algorithm>
#include <utility>

namespace Conformal_geometry_processing {

CGP_INLINE void internal::Row_major_multivector::append(const Vectors& v)
{
  for (Eigen::Index j = 0; j < v.cols(); ++j, ++m_size)
    for (Eigen::Index i = 0; i < v.rows(); ++i) {
      const Quaternion<double> q = v(i, j);
      m_numbers.block<1, 4>(i, 4 * m_size) << q.w, q.x, q.y, q.z;
    }
}

CGP_INLINE internal::Row_major_multivector::Vectors internal::Row_major_multivector::columns(
    Eigen::Index first, Eigen::Index count) const
{
  Vectors v(rows(), count);
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < rows(); ++i) {
      const auto q = m_numbers.block<1, 4>(i, 4 * (first + j));
      v(i, j) = {q[0], q[1], q[2], q[3]};
    }
  return v;
}

CGP_INLINE internal::Row_major_multivector::Vectors internal::Row_major_multivector::gram(
    const Vectors& w, internal::Coefficients coefficients) const
{
  const Numbers products = used().transpose() * numbers(w);
  Vectors G(size(), w.cols());
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

CGP_INLINE internal::Row_major_multivector::Vectors internal::Row_major_multivector::combination(
    const Vectors& C) const
{
  const Numbers products = used() * right_factors(C);
  Vectors v(rows(), C.cols());
  for (Eigen::Index j = 0; j < v.cols(); ++j)
    for (Eigen::Index i = 0; i < v.rows(); ++i)
      v(i, j) = {products(i, 4 * j), products(i, 4 * j + 1), products(i, 4 * j + 2),
                 products(i, 4 * j + 3)};
  return v;
}

CGP_INLINE void internal::Row_major_multivector::combine(const Vectors& C)
{
  const Numbers factors = right_factors(C);
  const Eigen::Index most = 512;
  for (Eigen::Index first = 0; first < rows(); first += most) {
    const Eigen::Index count = (std::min)(most, rows() - first);
    const Numbers part = used().middleRows(first, count) * factors;
    m_numbers.block(first, 0, count, part.cols()) = part;
  }
  m_size = C.cols();
}

CGP_INLINE internal::Row_major_multivector::Numbers internal::Row_major_multivector::numbers(
    const Vectors& v)
{
  internal::Row_major_multivector panel(v.rows(), v.cols());
  panel.append(v);
  return std::move(panel.m_numbers);
}

CGP_INLINE internal::Row_major_multivector::Numbers internal::Row_major_multivector::right_factors(
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

}  // namespace Conformal_geometry_processing

#endif
