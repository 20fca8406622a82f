// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/krylov/Row_major_multivector.h>

#include <Eigen/Core>

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

}  // namespace Conformal_geometry_processing
