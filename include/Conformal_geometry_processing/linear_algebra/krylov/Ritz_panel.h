// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>

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

  /// the Rayleigh quotients of the columns
  Vector<double> values() const;

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

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Returns a basis of the span of some vectors V, as combinations V C with C^H G C = 1.
///
/// The Gram-Schmidt process on coefficients. Leaves out vectors that depend on the previous ones,
/// with a squared sine below 1e-11 to their span: such a direction consists mostly of rounding
/// errors and may lead to another eigenpair.
/// \param G the Gram matrix of V, d x d
/// \returns d x r, r <= d; columns are triangular up to those left out
Block<Quaternion<double>> orthonormal_combinations(const Block<Quaternion<double>>& G);

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Makes the columns of p N-orthonormal, without those that `orthonormal_combinations()`
/// leaves out.
void orthonormalize(internal::Ritz_panel& p);

}  // namespace Conformal_geometry_processing
