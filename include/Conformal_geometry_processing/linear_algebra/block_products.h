// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_BLOCK_PRODUCTS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_BLOCK_PRODUCTS_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief A^H B: the inner products of the columns of A with those of B.
///
/// Written out because Eigen's dense products may exchange their factors, which quaternions do not
/// allow.
template <class FT>
Block<Quaternion<FT>> gram_matrix(const Block<Quaternion<FT>>& A, const Block<Quaternion<FT>>& B)
{
  Block<Quaternion<FT>> G(A.cols(), B.cols());
  for (Eigen::Index j = 0; j < B.cols(); ++j)
    for (Eigen::Index i = 0; i < A.cols(); ++i) G(i, j) = inner_product(A.col(i), B.col(j));
  return G;
}

/// \ingroup PkgLinearAlgebra
/// \brief y += x q for columns x and y; y may be a column of the same block as x.
template <class Y, class X, class FT>
void add_multiple(Y&& y, const X& x, const Quaternion<FT>& q)
{
  for (Eigen::Index i = 0; i < x.size(); ++i) y[i] += x[i] * q;
}

/// \ingroup PkgLinearAlgebra
/// \brief W += V C, in place: combines the columns of V with coefficients from the right.
template <class FT>
void add_combination(Block<Quaternion<FT>>& W, const Block<Quaternion<FT>>& V,
                     const Block<Quaternion<FT>>& C)
{
  for (Eigen::Index j = 0; j < C.cols(); ++j)
    for (Eigen::Index k = 0; k < V.cols(); ++k) add_multiple(W.col(j), V.col(k), C(k, j));
}

/// \ingroup PkgLinearAlgebra
/// \brief V C
template <class FT>
Block<Quaternion<FT>> combination(const Block<Quaternion<FT>>& V, const Block<Quaternion<FT>>& C)
{
  Block<Quaternion<FT>> W = Block<Quaternion<FT>>::Constant(V.rows(), C.cols(), Quaternion<FT>{});
  add_combination(W, V, C);
  return W;
}

/// \ingroup PkgLinearAlgebra
/// \brief multiplies column j of V by s
template <class FT>
void scale_column(Block<Quaternion<FT>>& V, Eigen::Index j, FT s)
{
  for (Eigen::Index i = 0; i < V.rows(); ++i) V(i, j) *= s;
}

}  // namespace Conformal_geometry_processing

#endif
