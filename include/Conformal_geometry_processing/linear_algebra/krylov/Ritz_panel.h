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

/// \ingroup PkgLinearAlgebra
/// \brief some vectors V together with K V and N V: what an eigenvalue iteration for
/// K x = N x theta combines, so that K and N are not applied again to combinations.
struct Ritz_panel {
  Block<Quaternion<double>> v, kv, nv;
  Coefficients coefficients = Coefficients::quaternions;

  Eigen::Index size() const { return v.cols(); }

  /// A^H B, in which combinations are sought
  Block<Quaternion<double>> gram(const Block<Quaternion<double>>& A,
                                 const Block<Quaternion<double>>& B) const;

  std::array<Block<Quaternion<double>>*, 3> parts() { return {&v, &kv, &nv}; }

  /// the Rayleigh quotient of column j
  double value(Eigen::Index j) const;

  /// sets the columns of r to K x - N x theta, with theta the Rayleigh quotient of x
  void residual(Block<Quaternion<double>>& r) const;
};

/// \relates Ritz_panel
/// finds what K and N make of p.v, in the memory that the panel has
template <class K, class N>
void apply_operators(const K& apply_k, const N& apply_n, Ritz_panel& p)
{
  apply_operator(apply_k, p.v, p.kv);
  apply_operator(apply_n, p.v, p.nv);
}

/// \relates Ritz_panel
/// V with what K and N make of it
template <class K, class N>
Ritz_panel make_panel(const K& apply_k, const N& apply_n, Block<Quaternion<double>> v,
                      Coefficients coefficients = Coefficients::quaternions)
{
  Ritz_panel p{std::move(v), {}, {}, coefficients};
  apply_operators(apply_k, apply_n, p);
  return p;
}

/// \relates Ritz_panel
/// \brief p = p C + q D, in place
void replace_by_combination(Ritz_panel& p, const Block<Quaternion<double>>& C, const Ritz_panel& q,
                            const Block<Quaternion<double>>& D);

/// \relates Ritz_panel
/// \brief takes off p what lies in the span of the N-orthonormal columns of `base`.
///
/// Twice: what rounding leaves the first time may be all that remains of p.
void project_out(Ritz_panel& p, const Ritz_panel& base);

/// \relates Ritz_panel
/// \brief makes the columns of p N-orthonormal by the method of Gram and Schmidt.
///
/// Drops columns that depend on those before: of squared sine below 1e-11 to their span. Below
/// this, a direction is mostly rounding errors, and may lead to another eigenpair.
void orthonormalize(Ritz_panel& p);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/krylov/Ritz_panel_impl.h>
#endif

#endif
