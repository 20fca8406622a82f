// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/multigrid/Multigrid_solver.h>
#include <Quaternionic_linear_algebra/multigrid/Prolongation.h>

#include <vector>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

/// Matrices in single precision, sparse ones as dense ones, and vectors as multigrid stores them.
namespace cgp_test {

template <class Scalar>
using Entry_of = typename CGP::internal::Rounding_remainder<Scalar>::Entry;

template <class Scalar>
CGP::Hermitian_sparse_matrix<Entry_of<Scalar>> single(const CGP::Hermitian_sparse_matrix<Scalar>& A)
{
  CGP::Hermitian_sparse_matrix<Entry_of<Scalar>> S(A.shared_pattern());
  for (int k = 0; k < A.pattern().size_of_entries(); ++k)
    S.value(k) = CGP::internal::to_single(A.value(k));
  return S;
}

/// n x n, or 4n x 4n
template <class Scalar, class Entry>
Eigen::MatrixXd real_form_of_single(const CGP::Hermitian_sparse_matrix<Entry>& A)
{
  CGP::Hermitian_sparse_matrix<Scalar> D(A.shared_pattern());
  for (int k = 0; k < A.pattern().size_of_entries(); ++k)
    D.value(k) = CGP::internal::to_double(A.value(k));
  return real_form(D);
}

/// P, with every entry times the identity of `planes` rows
inline Eigen::MatrixXd real_form(const CGP::internal::Prolongation& P, int planes = 1)
{
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(planes * P.fine_size(), planes * P.coarse_size);
  for (int i = 0; i < P.fine_size(); ++i)
    P.for_each_in_row(i, [&](int I, float weight) {
      for (int q = 0; q < planes; ++q) D(planes * i + q, planes * I + q) += double(weight);
    });
  return D;
}

template <class Scalar>
constexpr int planes_of = int(sizeof(Scalar) / sizeof(double));

/// four numbers per vertex are one quaternion, or a row of four columns
template <class Scalar>
constexpr int columns_of = 4 / planes_of<Scalar>;

/// number q of the four numbers of vertex i, where `columns` are as `real_columns()` gives them
template <class Scalar>
double& lane(Eigen::MatrixXd& columns, int i, int q)
{
  return planes_of<Scalar> == 1 ? columns(i, q) : columns(4 * i + q, 0);
}

/// |a - b| / |b|
inline double relative_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return (a - b).norm() / b.norm();
}

}  // namespace cgp_test
