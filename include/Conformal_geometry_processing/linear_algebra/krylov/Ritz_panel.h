// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_RITZ_PANEL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_RITZ_PANEL_H

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>

#include <Eigen/Core>

#include <array>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Some vectors V together with K V and N V, which an eigensolver for K x = N x theta
/// combines linearly, so that K and N are not applied again to combinations.
struct Ritz_panel {
  Block<Quaternion<double>> v, kv, nv;
  Coefficients coefficients = Coefficients::quaternions;

  Eigen::Index size() const { return v.cols(); }

  /// A^H B, reduced to the type of the coefficients
  Block<Quaternion<double>> gram(const Block<Quaternion<double>>& A,
                                 const Block<Quaternion<double>>& B) const;

  std::array<Block<Quaternion<double>>*, 3> parts() { return {&v, &kv, &nv}; }

  /// Rayleigh quotient of column j
  double value(Eigen::Index j) const;

  /// Sets the columns of r to K x - N x theta, with theta the Rayleigh quotient of x
  void residual(Block<Quaternion<double>>& r) const;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// Computes K p.v and N p.v, in the memory of the panel
template <class K, class N>
void apply_operators(const K& apply_k, const N& apply_n, internal::Ritz_panel& p)
{
  apply_operator(apply_k, p.v, p.kv);
  apply_operator(apply_n, p.v, p.nv);
}

/// \ingroup PkgLinearAlgebra
/// Makes a panel of v, K v and N v
template <class K, class N>
internal::Ritz_panel make_panel(
    const K& apply_k, const N& apply_n, Block<Quaternion<double>> v,
    internal::Coefficients coefficients = internal::Coefficients::quaternions)
{
  internal::Ritz_panel p{std::move(v), {}, {}, coefficients};
  apply_operators(apply_k, apply_n, p);
  return p;
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes p = p C + q D, in place
void replace_by_combination(internal::Ritz_panel& p, const Block<Quaternion<double>>& C,
                            const internal::Ritz_panel& q, const Block<Quaternion<double>>& D);

/// \ingroup PkgLinearAlgebra
/// \brief Projects p to the N-orthogonal complement of the N-orthonormal columns of `base`.
///
/// Projects twice, because rounding errors of the first pass may dominate the rest of p.
void project_out(internal::Ritz_panel& p, const internal::Ritz_panel& base);

/// \ingroup PkgLinearAlgebra
/// \brief Makes the columns of p N-orthonormal by the Gram-Schmidt process.
///
/// Drops columns that depend on the previous ones, with a squared sine below 1e-11 to their span.
/// Below this, a direction consists mostly of rounding errors and may lead to another eigenpair.
void orthonormalize(internal::Ritz_panel& p);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/krylov/Ritz_panel_impl.h>
#endif

#endif
