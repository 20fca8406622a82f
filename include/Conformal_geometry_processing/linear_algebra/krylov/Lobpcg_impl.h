// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LOBPCG_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LOBPCG_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>

#include <Eigen/Core>

#include <functional>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

// S^H K S for S = [x, w, p].
CGP_INLINE Lobpcg_space::Vectors Lobpcg_space::projection() const
{
  Vectors G(x.size() + size_of_directions(), x.size() + size_of_directions());
  Eigen::Index column = 0;
  for (const Ritz_panel* b : panels()) {
    Eigen::Index row = 0;
    for (const Ritz_panel* a : panels()) {
      if (row <= column) G.block(row, column, a->size(), b->size()) = x.gram(a->v, b->kv);
      row += a->size();
    }
    column += b->size();
  }
  for (Eigen::Index j = 0; j < G.cols(); ++j)
    for (Eigen::Index i = j + 1; i < G.rows(); ++i) G(i, j) = conjugate(G(j, i));
  return G;
}

// Moves x to [x, w, p] C. Updates only the vectors of x: K and N are applied to them again.
CGP_INLINE void Lobpcg_space::advance(const Vectors& C)
{
  const Vectors c_x = C.topRows(x.size()), c_w = C.middleRows(x.size(), w.size()),
                c_p = C.bottomRows(p.size());
  Vectors one = Vectors::Constant(C.cols(), C.cols(), {});
  for (Eigen::Index j = 0; j < C.cols(); ++j) one(j, j).w = 1;
  replace_by_combination(p, c_p, w, c_w);
  replace_by_combination(x.v, c_x, p.v, one);
}

CGP_INLINE Eigensolver_result
lobpcg(const Block_function& apply_k, const Block_function& apply_n,
       const Block_function& precondition, Block<Quaternion<double>> x0,
       const Eigensolver_options& options,
       const std::function<bool(const Eigensolver_progress&)>& go_further)
{
  using Vectors = Block<Quaternion<double>>;
  Eigensolver_convergence convergence("lobpcg", options, x0);
  Lobpcg_space space;
  auto& [x, w, p] = space;
  x = convergence.initial(make_panel(apply_k, apply_n, std::move(x0), options.coefficients));
  w.coefficients = p.coefficients = options.coefficients;
  const Vectors first = hermitian_jacobi(x.gram(x.v, x.kv)).vectors;
  for (Vectors* part : x.parts()) *part = combination(*part, first);
  while (true) {
    Vectors& r = w.kv;  // overwritten by K w later
    x.residual(r);
    apply_operator(precondition, r, w.v);
    convergence.count_solve();
    if (convergence.is_last(x, r, w.v, go_further)) break;

    space.orthonormalize_directions(apply_k, apply_n);
    if (space.size_of_directions() == 0) {
      convergence.stop();
      break;
    }
    const auto ritz = hermitian_jacobi(space.projection());
    convergence.note_next_value(ritz.values[x.size()]);
    space.advance(ritz.vectors.leftCols(x.size()));
    convergence.count_iteration();
    const bool has_adapted = convergence.has_adapted(x);
    // Applied anew, so that the residual is the true one and not that of accumulated combinations.
    apply_operators(apply_k, apply_n, x);
    if (has_adapted) apply_operator(apply_k, p.v, p.kv);
  }
  return convergence.result();
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
