// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

#include <complex>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/dense.h"
#include "support/random.h"

/// Random sparse Hermitian matrices, and the dense real matrices they stand for.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;
using Pattern = std::shared_ptr<const CGP::Sparse_pattern>;

/// the pattern of a graph given by its edges, which may repeat; loops are ignored
Pattern pattern_of_edges(int n, const std::vector<std::pair<int, int>>& edges);

/// n vertices in a ring, and n chords: a connected graph
Pattern random_pattern(int n, std::uint64_t seed);

/// all entries
Pattern full_pattern(int n);

/// rows x columns vertices with their four neighbours
Pattern grid_pattern(int rows, int columns);

template <class Scalar>
Scalar random_scalar(Random& random)
{
  if constexpr (std::is_same_v<Scalar, double>) {
    return random.number();
  } else if constexpr (std::is_same_v<Scalar, std::complex<double>>) {
    const double re = random.number(), im = random.number();
    return {re, im};
  } else {
    return random.quaternion();
  }
}

/// random entries with a real diagonal
template <class Scalar>
CGP::Hermitian_sparse_matrix<Scalar> random_hermitian(const Pattern& pattern, std::uint64_t seed)
{
  Random random(seed);
  CGP::Hermitian_sparse_matrix<Scalar> A(pattern);
  for (int j = 0; j < A.size(); ++j)
    for (int k = pattern->offsets[at(j)]; k < pattern->offsets[at(j) + 1]; ++k)
      A.value(k) = k == pattern->offsets[at(j)]
                       ? CGP::internal::Scalar_traits<Scalar>::from_real(random.number())
                       : random_scalar<Scalar>(random);
  return A;
}

/// adds s to the diagonal
template <class Scalar>
CGP::Hermitian_sparse_matrix<Scalar> plus_diagonal(CGP::Hermitian_sparse_matrix<Scalar> A,
                                                   const Eigen::VectorXd& s)
{
  for (int j = 0; j < A.size(); ++j)
    A.value(A.pattern().offsets[at(j)]) += CGP::internal::Scalar_traits<Scalar>::from_real(s[j]);
  return A;
}

/// diagonally dominant
template <class Scalar>
CGP::Hermitian_sparse_matrix<Scalar> random_definite(const Pattern& pattern, std::uint64_t seed)
{
  const auto A = random_hermitian<Scalar>(pattern, seed);
  Eigen::VectorXd s = Eigen::VectorXd::Constant(A.size(), 1.1);
  A.for_each_entry([&](int i, int j, const Scalar& a) {
    double size = 0;
    if constexpr (std::is_same_v<Scalar, Quaternion<double>>)
      size = norm(a);
    else
      size = std::abs(a);
    s[i] += size;
    s[j] += size;
  });
  return plus_diagonal(A, s);
}

/// the Laplacian of the graph with random positive weights
CGP::Hermitian_sparse_matrix<double> random_laplacian(const Pattern& pattern, std::uint64_t seed);

/// n x n or 2n x 2n, for quaternions 4n x 4n: left multiplication on components re, im or w, x, y,
/// z
Eigen::MatrixXd real_form(const CGP::Block<double>& A);
Eigen::MatrixXd real_form(const CGP::Block<std::complex<double>>& A);
template <class Scalar>
Eigen::MatrixXd real_form(const CGP::Hermitian_sparse_matrix<Scalar>& A)
{
  CGP::Block<Scalar> D(A.size(), A.size());
  for (int j = 0; j < A.size(); ++j)
    for (int i = 0; i < A.size(); ++i) D(i, j) = A.coefficient(i, j);
  return real_form(D);
}

/// the components of the columns
Eigen::MatrixXd real_columns(const CGP::Block<double>& b);
Eigen::MatrixXd real_columns(const CGP::Block<std::complex<double>>& b);
Eigen::MatrixXd real_columns(const CGP::Block<Quaternion<double>>& b);

template <class Scalar>
CGP::Block<Scalar> random_block(int rows, int columns, std::uint64_t seed)
{
  Random random(seed);
  CGP::Block<Scalar> b(rows, columns);
  for (int c = 0; c < columns; ++c)
    for (int i = 0; i < rows; ++i) b(i, c) = random_scalar<Scalar>(random);
  return b;
}

/// one mass on all components of a quaternion
Eigen::VectorXd four_times(const Eigen::VectorXd& m);

}  // namespace cgp_test
