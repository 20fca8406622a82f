// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <cstddef>

namespace Conformal_geometry_processing::internal {

/// Fills a Hermitian form by its upper triangle, in the type of the coefficients
void complete_hermitian(Coefficients coefficients, Lobpcg_space::Vectors& form)
{
  for (Eigen::Index j = 0; j < form.cols(); ++j)
    for (Eigen::Index i = 0; i <= j; ++i) {
      form(i, j) = reduced_to(coefficients, form(i, j));
      if (i < j) form(j, i) = conjugate(form(i, j));
    }
}

// Some rows at a time, so that every vector is read once.
Lobpcg_space::Forms Lobpcg_space::forms() const
{
  const std::ptrdiff_t at_once = 1024;
  const Vectors zero = Vectors::Constant(size(), size(), {});
  const auto add = [this](std::ptrdiff_t first, std::ptrdiff_t last, Forms& sum) {
    Eigen::Index column = 0;
    for (const Ritz_panel* b : panels())
      for (Eigen::Index j = 0; j < b->size(); ++j, ++column) {
        Eigen::Index row = 0;
        for (const Ritz_panel* a : panels())
          for (Eigen::Index i = 0; i < a->size() && row <= column; ++i, ++row) {
            const auto v = a->v.col(i).segment(first, last - first);
            sum.n(row, column) += inner_product(v, b->nv.col(j).segment(first, last - first));
            sum.k(row, column) += inner_product(v, b->kv.col(j).segment(first, last - first));
          }
      }
  };
  Forms sum = sum_of_ranges(x.v.rows(), at_once, Forms{zero, zero}, add);
  for (Vectors* form : {&sum.n, &sum.k}) complete_hermitian(x.coefficients, *form);
  return sum;
}

// Moves x to S C. Updates only the vectors of x: K and N are applied to them again.
void Lobpcg_space::advance(const Vectors& C)
{
  const Vectors c_x = C.topRows(x.size()), c_w = C.middleRows(x.size(), w.size()),
                c_p = C.bottomRows(p.size());
  Vectors one = Vectors::Constant(C.cols(), C.cols(), {});
  for (Eigen::Index j = 0; j < C.cols(); ++j) one(j, j).w = 1;
  replace_by_combination(p, c_p, w, c_w);
  replace_by_combination(x.v, c_x, p.v, one);
}

Eigensolver_result lobpcg(const Block_function& apply_k, const Block_function& apply_n,
                          const Block_function& precondition, Block<Quaternion<double>> x0,
                          const Eigensolver_options& options,
                          const std::function<bool(const Eigensolver_progress&)>& go_further)
{
  using Vectors = Block<Quaternion<double>>;
  const Thread_team team;
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
    apply_operators(apply_k, apply_n, w);
    const auto forms = space.forms();
    const Vectors basis = orthonormal_combinations(forms.n);
    if (basis.cols() <= x.size()) {
      convergence.stop();
      break;
    }
    const auto ritz = hermitian_jacobi(x.gram(basis, combination(forms.k, basis)));
    convergence.note_next_value(ritz.values[x.size()]);
    space.advance(combination(basis, Vectors(ritz.vectors.leftCols(x.size()))));
    convergence.count_iteration();
    const bool has_adapted = convergence.has_adapted(x.v);
    // Applied anew, so that the residual is the true one and not that of accumulated combinations.
    apply_operators(apply_k, apply_n, x);
    if (has_adapted) apply_operator(apply_k, p.v, p.kv);
  }
  return convergence.result();
}

}  // namespace Conformal_geometry_processing::internal
