// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief adds the part of v that is orthogonal to the columns of V, scaled to norm 1, as the last
/// column; v may be a column of another block. O(n k) for V of n x k.
/// \param V orthonormal with respect to `weights`, or empty
/// \param weights n, positive
/// \returns false, and leaves V as it is, if v is in the span up to rounding
template <class FT>
bool extend_orthonormal(Block<Quaternion<FT>>& V, const Vector<FT>& weights,
                        Quaternion_vector<FT> v)
{
  const auto norm = [&] { return std::sqrt(inner_product(v, weights, v).w); };
  const FT length = norm(), rounding = FT(1e-12);
  for (int pass = 0; pass < 2; ++pass)
    for (Eigen::Index j = 0; j < V.cols(); ++j)
      add_multiple(v, V.col(j), -inner_product(V.col(j), weights, v));
  const FT rest = norm();
  if (!(rest > rounding * length)) return false;
  V.conservativeResize(v.size(), V.cols() + 1);
  V.rightCols(1) = v;
  scale_column(V, V.cols() - 1, 1 / rest);
  return true;
}

}  // namespace Conformal_geometry_processing
