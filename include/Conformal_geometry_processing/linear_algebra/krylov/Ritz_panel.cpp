// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/krylov/Ritz_panel.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

Block<Quaternion<double>> internal::Ritz_panel::gram(const Block<Quaternion<double>>& A,
                                                     const Block<Quaternion<double>>& B) const
{
  return gram_matrix(A, B, coefficients);
}

Vector<double> internal::Ritz_panel::values() const
{
  Vector<double> theta(size());
  for (Eigen::Index j = 0; j < size(); ++j)
    theta[j] = inner_product(v.col(j), kv.col(j)).w / inner_product(v.col(j), nv.col(j)).w;
  return theta;
}

void internal::Ritz_panel::residual(Block<Quaternion<double>>& r) const
{
  const Vector<double> theta = values();
  r.resize(v.rows(), size());
  const std::ptrdiff_t least = 8192;
  for_each_range(v.rows(), least, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (Eigen::Index j = 0; j < size(); ++j)
      r.col(j).segment(first, last - first) = kv.col(j).segment(first, last - first) -
                                              theta[j] * nv.col(j).segment(first, last - first);
  });
}

void replace_by_combination(internal::Ritz_panel& p, const Block<Quaternion<double>>& C,
                            const internal::Ritz_panel& q, const Block<Quaternion<double>>& D)
{
  replace_by_combination(p.v, C, q.v, D);
  replace_by_combination(p.kv, C, q.kv, D);
  replace_by_combination(p.nv, C, q.nv, D);
}

Block<Quaternion<double>> internal::orthonormal_combinations(const Block<Quaternion<double>>& G)
{
  using Vectors = Block<Quaternion<double>>;
  const double degenerate = 1e-11;
  const Eigen::Index d = G.cols();
  Vectors C(d, 0);
  for (Eigen::Index j = 0; j < d; ++j) {
    Vectors c = Vectors::Constant(d, 1, {});
    c(j, 0).w = 1 / std::sqrt(G(j, j).w);
    for (int pass = 0; pass < 2; ++pass)
      add_combination(c, C, Vectors(-gram_matrix(C, combination(G, c))));
    const double rest = inner_product(c.col(0), combination(G, c).col(0)).w;
    if (!(rest > degenerate) || !std::isfinite(rest)) continue;
    C.conservativeResize(d, C.cols() + 1);
    C.rightCols(1) = c;
    scale_column(C, C.cols() - 1, 1 / std::sqrt(rest));
  }
  return C;
}

void orthonormalize(internal::Ritz_panel& p)
{
  const auto C = internal::orthonormal_combinations(p.gram(p.v, p.nv));
  for (auto* part : p.parts()) *part = combination(*part, C);
}

}  // namespace Conformal_geometry_processing
