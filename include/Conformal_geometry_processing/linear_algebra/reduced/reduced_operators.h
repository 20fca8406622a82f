// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Reduced_basis.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief The operator x -> B B^T A x for all columns of x at once: the matrix B^T A B as an
/// operator on quaternionic vectors, with values in the reduced space. Stores references.
///
/// With `inverse_operator()` of a reduced solver an eigensolver can iterate on such vectors,
/// provided that it combines them with *real* coefficients: its inner products are those of
/// `real_gram_matrix()`.
template <class FT>
auto reduced_operator(const Hermitian_sparse_matrix<Quaternion<FT>>& A,
                      const internal::Reduced_basis<FT>& basis)
{
  return [apply = block_operator(A), &basis](const Block<Quaternion<FT>>& x) {
    return basis.project(apply(x));
  };
}

/// \ingroup PkgLinearAlgebra
/// \brief Returns Re A^H C: the real inner products of the columns of A with those of C.
template <class FT>
Block<FT> real_gram_matrix(const Block<Quaternion<FT>>& A, const Block<Quaternion<FT>>& C)
{
  const auto numbers = [](const Block<Quaternion<FT>>& x) {
    return Eigen::Map<const Block<FT>>(reinterpret_cast<const FT*>(x.data()), 4 * x.rows(),
                                       x.cols());
  };
  return numbers(A).transpose() * numbers(C);
}

}  // namespace Conformal_geometry_processing
