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
/// \brief V C: combines the columns of V with coefficients from the right.
template <class FT>
Block<Quaternion<FT>> combination(const Block<Quaternion<FT>>& V, const Block<Quaternion<FT>>& C)
{
  Block<Quaternion<FT>> W = Block<Quaternion<FT>>::Constant(V.rows(), C.cols(), Quaternion<FT>{});
  for (Eigen::Index j = 0; j < C.cols(); ++j)
    for (Eigen::Index k = 0; k < V.cols(); ++k)
      for (Eigen::Index i = 0; i < V.rows(); ++i) W(i, j) += V(i, k) * C(k, j);
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
