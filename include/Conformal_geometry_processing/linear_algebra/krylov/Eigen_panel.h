// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_EIGEN_PANEL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_EIGEN_PANEL_H

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>

#include <array>
#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief some vectors V together with K V and N V: what an eigenvalue iteration for
/// K x = N x theta combines, so that K and N are not applied again to combinations.
struct Eigen_panel {
  Block<Quaternion<double>> v, kv, nv;
  Coefficients coefficients = Coefficients::quaternions;

  Eigen::Index size() const { return v.cols(); }

  /// A^H B, in which combinations are sought
  Block<Quaternion<double>> gram(const Block<Quaternion<double>>& A,
                                 const Block<Quaternion<double>>& B) const
  {
    return gram_matrix(A, B, coefficients);
  }

  std::array<Block<Quaternion<double>>*, 3> parts() { return {&v, &kv, &nv}; }

  /// the Rayleigh quotient of column j
  double value(Eigen::Index j) const
  {
    return inner_product(v.col(j), kv.col(j)).w / inner_product(v.col(j), nv.col(j)).w;
  }

  /// sets the columns of r to K x - N x theta, with theta the Rayleigh quotient of x
  void residual(Block<Quaternion<double>>& r) const
  {
    r = kv;
    for (Eigen::Index j = 0; j < size(); ++j)
      add_multiple(r.col(j), nv.col(j), Quaternion<double>{-value(j), 0, 0, 0});
  }
};

/// \relates Eigen_panel
/// finds what K and N make of p.v, in the memory that the panel has
template <class K, class N>
void apply_operators(const K& apply_k, const N& apply_n, Eigen_panel& p)
{
  apply_operator(apply_k, p.v, p.kv);
  apply_operator(apply_n, p.v, p.nv);
}

/// \relates Eigen_panel
/// V with what K and N make of it
template <class K, class N>
Eigen_panel make_panel(const K& apply_k, const N& apply_n, Block<Quaternion<double>> v,
                       Coefficients coefficients = Coefficients::quaternions)
{
  Eigen_panel p{std::move(v), {}, {}, coefficients};
  apply_operators(apply_k, apply_n, p);
  return p;
}

/// \relates Eigen_panel
/// \brief p = p C + q D, in place
inline void replace_by_combination(Eigen_panel& p, const Block<Quaternion<double>>& C,
                                   const Eigen_panel& q, const Block<Quaternion<double>>& D)
{
  replace_by_combination(p.v, C, q.v, D);
  replace_by_combination(p.kv, C, q.kv, D);
  replace_by_combination(p.nv, C, q.nv, D);
}

/// \relates Eigen_panel
/// \brief takes off p what lies in the span of the N-orthonormal columns of `base`.
///
/// Twice: what rounding leaves the first time may be all that remains of p.
inline void project_out(Eigen_panel& p, const Eigen_panel& base)
{
  if (p.size() == 0 || base.size() == 0) return;
  for (int pass = 0; pass < 2; ++pass) {
    const Block<Quaternion<double>> shadow = -base.gram(base.nv, p.v);
    add_combination(p.v, base.v, shadow);
    add_combination(p.kv, base.kv, shadow);
    add_combination(p.nv, base.nv, shadow);
  }
}

namespace internal {

// The N-norm of column j.
inline double column_norm(const Eigen_panel& p, Eigen::Index j)
{
  return std::sqrt(inner_product(p.v.col(j), p.nv.col(j)).w);
}

// Takes off column j what lies in the span of the orthonormal columns before it; twice, as above.
inline void project_column(Eigen_panel& p, Eigen::Index j)
{
  for (int pass = 0; pass < 2; ++pass)
    for (Eigen::Index i = 0; i < j; ++i) {
      const Quaternion<double> shadow =
          -reduced_to(p.coefficients, inner_product(p.nv.col(i), p.v.col(j)));
      for (auto* part : p.parts()) add_multiple(part->col(j), part->col(i), shadow);
    }
}

}  // namespace internal

/// \relates Eigen_panel
/// \brief makes the columns of p N-orthonormal by the method of Gram and Schmidt.
///
/// Drops columns that depend on those before: of squared sine below 1e-11 to their span. Below
/// this, a direction is mostly rounding errors, and may lead to another eigenpair.
inline void orthonormalize(Eigen_panel& p)
{
  const double degenerate = 1e-11;
  Eigen::Index kept = 0;
  for (Eigen::Index j = 0; j < p.size(); ++j) {
    if (kept < j)
      for (auto* part : p.parts()) part->col(kept) = part->col(j);
    const double length = internal::column_norm(p, kept);
    internal::project_column(p, kept);
    const double rest = internal::column_norm(p, kept);
    if (!(rest * rest > degenerate * length * length) || !std::isfinite(1 / rest)) continue;
    for (auto* part : p.parts()) scale_column(*part, kept, 1 / rest);
    ++kept;
  }
  if (kept < p.size())
    for (auto* part : p.parts()) part->conservativeResize(Eigen::NoChange, kept);
}

}  // namespace Conformal_geometry_processing

#endif
