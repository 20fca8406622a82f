// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Harmonic_basis.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

Eigen::MatrixXd Harmonic_basis::coefficients(const Eigen::VectorXd& w,
                                             const Eigen::MatrixXd& alpha) const
{
  const Eigen::MatrixXd weighted = w.asDiagonal() * alpha;
  Eigen::MatrixXd products(size(), alpha.cols());
  for (Eigen::Index i = 0; i < products.rows(); ++i)  // each form is read once
    for (Eigen::Index k = 0; k < alpha.cols(); ++k)
      products(i, k) = one_forms.col(i).dot(weighted.col(k));
  return products;
}

Eigen::MatrixXd Harmonic_basis::combinations(const Eigen::MatrixXd& c) const
{
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(one_forms.rows(), c.cols());
  for (Eigen::Index i = 0; i < c.rows(); ++i)
    for (Eigen::Index k = 0; k < c.cols(); ++k) sums.col(k) += c(i, k) * one_forms.col(i);
  return sums;
}

namespace internal {

void remove_exact_parts(const Surface_ref& surface, const Eigen::VectorXd& w,
                        const Grounded_solver& laplacian, Eigen::MatrixXd& forms)
{
  constexpr Eigen::Index at_once = 16;  // columns per solve: bounds the memory for solutions
  for (Eigen::Index first = 0; first < forms.cols(); first += at_once) {
    auto some = forms.middleCols(first, (std::min)(at_once, forms.cols() - first));
    some -= differential(surface, laplacian.solve(codifferential(surface, w, some)));
  }
}

/// The fields of closed forms, one form per column, with each vector multiplied by the square root
/// of its sheet's area: the inner products of the columns are those of the forms.
Eigen::MatrixXd weighted_fields(const Surface_ref& surface, const Eigen::MatrixXd& forms)
{
  Eigen::VectorXd roots(surface.size_of_sheets());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    roots[s] = std::sqrt(sheet.share * sheet.area);
  }
  Eigen::MatrixXd columns(3 * surface.size_of_sheets(), forms.cols());
  for (Eigen::Index i = 0; i < forms.cols(); ++i) {
    const Points scaled = tangent_field(surface, forms.col(i)) * roots.asDiagonal();
    columns.col(i) = scaled.reshaped();
  }
  return columns;
}

void require_independent(bool are_independent)
{
  if (!are_independent)
    throw Precondition_error("orthonormalize", "the 1-forms are not linearly independent");
}

/// whether the diagonal, the norm of each form's component orthogonal to the preceding forms, is
/// far from 0
bool has_full_rank(const Eigen::MatrixXd& R)
{
  const Eigen::VectorXd pivots = R.diagonal();
  const double least_pivot = 1e-7;  // relative: half of the digits
  return pivots.allFinite() && pivots.minCoeff() > least_pivot * pivots.maxCoeff();
}

/// the upper triangular factor, with a positive diagonal, of the forms' QR decomposition
Eigen::MatrixXd triangular_factor(const Surface_ref& surface, const Eigen::MatrixXd& forms)
{
  Eigen::MatrixXd V = weighted_fields(surface, forms);
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(V);
  const Eigen::MatrixXd R = V.topRows(V.cols()).triangularView<Eigen::Upper>();
  const Eigen::VectorXd signs =
      (R.diagonal().array() < 0).select(-1., Eigen::VectorXd::Ones(R.rows()));
  return signs.asDiagonal() * R;
}

void orthonormalize_forms(const Surface_ref& surface, Eigen::MatrixXd& forms)
{
  if (forms.cols() == 0) return;
  require_independent(forms.cols() <= 3 * surface.size_of_sheets());
  const Eigen::MatrixXd R = triangular_factor(surface, forms);
  require_independent(has_full_rank(R));
  R.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(forms);
  // The Gram matrix is the identity but for rounding errors, which its Cholesky factor removes.
  const Eigen::MatrixXd V = weighted_fields(surface, forms), gram = V.transpose() * V;
  gram.llt().matrixU().solveInPlace<Eigen::OnTheRight>(forms);
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
