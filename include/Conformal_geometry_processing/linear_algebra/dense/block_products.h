// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Field of the coefficients in linear combinations of quaternionic vectors.
///
/// Vectors with prescribed directions at the boundary (`Reduced_basis`) form a vector space over
/// the real numbers only: their inner product is the real part of the quaternionic one, and all
/// quantities derived from inner products are real as well.
enum class Coefficients { quaternions, reals };

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Returns q, or its real part
template <class FT>
Quaternion<FT> reduced_to(internal::Coefficients coefficients, const Quaternion<FT>& q)
{
  return coefficients == internal::Coefficients::reals ? Quaternion<FT>{q.w, 0, 0, 0} : q;
}

/// \ingroup PkgLinearAlgebra
/// \brief Returns A^H B, the inner products of the columns of A with those of B.
///
/// Does not use Eigen's dense products, which may swap their factors; quaternions do not commute.
template <class FT>
Block<Quaternion<FT>> gram_matrix(
    const Block<Quaternion<FT>>& A, const Block<Quaternion<FT>>& B,
    internal::Coefficients coefficients = internal::Coefficients::quaternions)
{
  Block<Quaternion<FT>> G(A.cols(), B.cols());
  for (Eigen::Index j = 0; j < B.cols(); ++j)
    for (Eigen::Index i = 0; i < A.cols(); ++i)
      G(i, j) = reduced_to(coefficients, inner_product(A.col(i), B.col(j)));
  return G;
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes y += x q for columns x and y; y may be a column of the same block as x.
/// \tparam Y, X vectors or columns with their own storage
template <class Y, class X, class FT>
void add_multiple(Y&& y, const X& x, const Quaternion<FT>& q)
{
  using Four = Eigen::Array<FT, 4, 1>;
  const std::ptrdiff_t least = 8192;
  internal::for_each_range(x.size(), least, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    // x q = x.w q + x.x (i q) + x.y (j q) + x.z (k q), a sum of products of a number and a vector.
    const Four w(q.w, q.x, q.y, q.z), i(-q.x, q.w, -q.z, q.y), j(-q.y, q.z, q.w, -q.x),
        k(-q.z, -q.y, q.x, q.w);
    for (std::ptrdiff_t n = first; n < last; ++n) {
      const Quaternion<FT> a = x[n];
      Eigen::Map<Four> sum(&y.coeffRef(n).w);
      sum += a.w * w + a.x * i + a.y * j + a.z * k;
    }
  });
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes W += V C in place: combines the columns of V with coefficients from the right.
template <class FT>
void add_combination(Block<Quaternion<FT>>& W, const Block<Quaternion<FT>>& V,
                     const Block<Quaternion<FT>>& C)
{
  for (Eigen::Index j = 0; j < C.cols(); ++j)
    for (Eigen::Index k = 0; k < V.cols(); ++k) add_multiple(W.col(j), V.col(k), C(k, j));
}

/// \ingroup PkgLinearAlgebra
/// \brief Returns V C
template <class FT>
Block<Quaternion<FT>> combination(const Block<Quaternion<FT>>& V, const Block<Quaternion<FT>>& C)
{
  Block<Quaternion<FT>> W = Block<Quaternion<FT>>::Constant(V.rows(), C.cols(), Quaternion<FT>{});
  add_combination(W, V, C);
  return W;
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes W = W C + V D, in the memory of W if its size does not change.
///
/// Processes some rows at a time to avoid another copy of W.
template <class FT>
void replace_by_combination(Block<Quaternion<FT>>& W, const Block<Quaternion<FT>>& C,
                            const Block<Quaternion<FT>>& V, const Block<Quaternion<FT>>& D)
{
  const Eigen::Index rows = V.rows(), most = 256, old = W.cols();
  if (old != D.cols()) W.conservativeResize(rows, (std::max)(old, D.cols()));
  const std::ptrdiff_t least = 2048;
  internal::for_each_range(rows, least, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    Block<Quaternion<FT>> part((std::min)(end - begin, most), D.cols());
    for (Eigen::Index first = begin; first < end; first += most) {
      const Eigen::Index count = (std::min)(most, end - first);
      part.setConstant(Quaternion<FT>{});
      for (Eigen::Index j = 0; j < D.cols(); ++j) {
        auto target = part.col(j).head(count);
        for (Eigen::Index k = 0; k < old; ++k)
          add_multiple(target, W.col(k).segment(first, count), C(k, j));
        for (Eigen::Index k = 0; k < V.cols(); ++k)
          add_multiple(target, V.col(k).segment(first, count), D(k, j));
      }
      W.block(first, 0, count, D.cols()) = part.topRows(count);
    }
  });
  if (old > D.cols()) W.conservativeResize(rows, D.cols());
}

/// \ingroup PkgLinearAlgebra
/// \brief Multiplies column j of V by s
template <class FT>
void scale_column(Block<Quaternion<FT>>& V, Eigen::Index j, FT s)
{
  for (Eigen::Index i = 0; i < V.rows(); ++i) V(i, j) *= s;
}

}  // namespace Conformal_geometry_processing
