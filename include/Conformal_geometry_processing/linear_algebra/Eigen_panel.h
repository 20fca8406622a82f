// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_EIGEN_PANEL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_EIGEN_PANEL_H

#include <Conformal_geometry_processing/linear_algebra/block_products.h>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief some vectors V together with K V and N V: what an eigenvalue iteration for
/// K x = N x theta combines, so that K and N are not applied again to combinations.
struct Eigen_panel {
  Block<Quaternion<double>> v, kv, nv;

  Eigen::Index size() const { return v.cols(); }

  /// the Rayleigh quotient of column j
  double value(Eigen::Index j) const
  {
    return inner_product(v.col(j), kv.col(j)).w / inner_product(v.col(j), nv.col(j)).w;
  }

  /// the columns K x - N x theta, with theta the Rayleigh quotient of x
  Block<Quaternion<double>> residual() const
  {
    Block<Quaternion<double>> r = kv;
    for (Eigen::Index j = 0; j < size(); ++j) {
      const double theta = value(j);
      for (Eigen::Index i = 0; i < v.rows(); ++i) r(i, j) -= nv(i, j) * theta;
    }
    return r;
  }
};

/// \relates Eigen_panel
/// V with what K and N make of it
template <class K, class N>
Eigen_panel make_panel(const K& apply_k, const N& apply_n, Block<Quaternion<double>> v)
{
  Eigen_panel p{std::move(v), {}, {}};
  p.kv = apply_k(p.v);
  p.nv = apply_n(p.v);
  return p;
}

/// \relates Eigen_panel
/// V C
inline Eigen_panel combination(const Eigen_panel& p, const Block<Quaternion<double>>& C)
{
  return {combination(p.v, C), combination(p.kv, C), combination(p.nv, C)};
}

/// \relates Eigen_panel
/// [a, b], side by side
inline Eigen_panel beside(const Eigen_panel& a, const Eigen_panel& b)
{
  if (b.size() == 0) return a;
  const auto join = [](const auto& x, const auto& y) {
    Block<Quaternion<double>> both(x.rows(), x.cols() + y.cols());
    both << x, y;
    return both;
  };
  return {join(a.v, b.v), join(a.kv, b.kv), join(a.nv, b.nv)};
}

/// \relates Eigen_panel
/// \brief takes off p what lies in the span of the N-orthonormal columns of `base`.
///
/// Twice: what rounding leaves the first time may be all that remains of p.
inline void project_out(Eigen_panel& p, const Eigen_panel& base)
{
  for (int pass = 0; pass < 2; ++pass) {
    const Block<Quaternion<double>> shadow = -gram_matrix(base.nv, p.v);
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

inline void divide_column(Eigen_panel& p, Eigen::Index j, double s)
{
  for (Block<Quaternion<double>>* part : {&p.v, &p.kv, &p.nv}) scale_column(*part, j, 1 / s);
}

// Takes off column j what lies in the span of the orthonormal columns before it; twice, as above.
inline void project_column(Eigen_panel& p, Eigen::Index j)
{
  for (int pass = 0; pass < 2; ++pass)
    for (Eigen::Index i = 0; i < j; ++i) {
      const Quaternion<double> shadow = -inner_product(p.nv.col(i), p.v.col(j));
      for (Block<Quaternion<double>>* part : {&p.v, &p.kv, &p.nv})
        add_multiple(part->col(j), part->col(i), shadow);
    }
}

}  // namespace internal

/// \relates Eigen_panel
/// \brief the Gram-Schmidt basis of the columns of p, N-orthonormal.
///
/// Drops columns that depend on those before: of squared sine below 1e-11 to their span. Below
/// this, a direction is mostly rounding errors, and may lead to another eigenpair.
inline Eigen_panel orthonormal_basis(Eigen_panel p)
{
  const double degenerate = 1e-11;
  Eigen::Index kept = 0;
  for (Eigen::Index j = 0; j < p.size(); ++j) {
    if (kept < j)
      for (Block<Quaternion<double>>* part : {&p.v, &p.kv, &p.nv}) part->col(kept) = part->col(j);
    const double length = internal::column_norm(p, kept);
    internal::project_column(p, kept);
    const double sine_length = internal::column_norm(p, kept);
    if (!(sine_length * sine_length > degenerate * length * length)) continue;
    if (!std::isfinite(1 / sine_length)) continue;
    internal::divide_column(p, kept, sine_length);
    ++kept;
  }
  for (Block<Quaternion<double>>* part : {&p.v, &p.kv, &p.nv})
    part->conservativeResize(Eigen::NoChange, kept);
  return p;
}

}  // namespace Conformal_geometry_processing

#endif
