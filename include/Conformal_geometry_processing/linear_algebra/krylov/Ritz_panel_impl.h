// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_RITZ_PANEL_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_RITZ_PANEL_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Ritz_panel.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE Block<Quaternion<double>> internal::Ritz_panel::gram(
    const Block<Quaternion<double>>& A, const Block<Quaternion<double>>& B) const
{
  return gram_matrix(A, B, coefficients);
}

CGP_INLINE double internal::Ritz_panel::value(Eigen::Index j) const
{
  return inner_product(v.col(j), kv.col(j)).w / inner_product(v.col(j), nv.col(j)).w;
}

CGP_INLINE void internal::Ritz_panel::residual(Block<Quaternion<double>>& r) const
{
  r = kv;
  for (Eigen::Index j = 0; j < size(); ++j)
    add_multiple(r.col(j), nv.col(j), Quaternion<double>{-value(j), 0, 0, 0});
}

CGP_INLINE void replace_by_combination(internal::Ritz_panel& p, const Block<Quaternion<double>>& C,
                                       const internal::Ritz_panel& q,
                                       const Block<Quaternion<double>>& D)
{
  replace_by_combination(p.v, C, q.v, D);
  replace_by_combination(p.kv, C, q.kv, D);
  replace_by_combination(p.nv, C, q.nv, D);
}

CGP_INLINE void project_out(internal::Ritz_panel& p, const internal::Ritz_panel& base)
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

CGP_INLINE double column_norm(const Ritz_panel& p, Eigen::Index j)
{
  return std::sqrt(inner_product(p.v.col(j), p.nv.col(j)).w);
}

CGP_INLINE void project_column(Ritz_panel& p, Eigen::Index j)
{
  for (int pass = 0; pass < 2; ++pass)
    for (Eigen::Index i = 0; i < j; ++i) {
      const Quaternion<double> shadow =
          -reduced_to(p.coefficients, inner_product(p.nv.col(i), p.v.col(j)));
      for (auto* part : p.parts()) add_multiple(part->col(j), part->col(i), shadow);
    }
}

}  // namespace internal

CGP_INLINE void orthonormalize(internal::Ritz_panel& p)
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
