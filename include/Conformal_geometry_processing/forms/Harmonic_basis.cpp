// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Harmonic_basis.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {
namespace internal {

Eigen::MatrixXd remove_exact_parts(const Surface_ref& surface, const Eigen::VectorXd& w,
                                   const Grounded_solver& laplacian, Eigen::MatrixXd& forms)
{
  constexpr Eigen::Index at_once = 16;  // columns per solve: bounds the memory beside the results
  Eigen::MatrixXd u(surface.size_of_vertices(), forms.cols());
  for (Eigen::Index first = 0; first < forms.cols(); first += at_once) {
    const Eigen::Index size = (std::min)(at_once, forms.cols() - first);
    auto some = forms.middleCols(first, size);
    u.middleCols(first, size) = laplacian.solve(codifferential(surface, w, some));
    some -= differential(surface, u.middleCols(first, size));
  }
  return u;
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

Eigen::MatrixXd orthonormalize_forms(const Surface_ref& surface, Eigen::MatrixXd& forms)
{
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(forms.cols(), forms.cols());
  if (forms.cols() == 0) return T;
  require_independent(forms.cols() <= 3 * surface.size_of_sheets());
  const auto divide_by = [&](const auto& triangle) {
    for (Eigen::MatrixXd* A : {&forms, &T}) triangle.template solveInPlace<Eigen::OnTheRight>(*A);
  };
  const Eigen::MatrixXd R = triangular_factor(surface, forms);
  require_independent(has_full_rank(R));
  divide_by(R.triangularView<Eigen::Upper>());
  // The Gram matrix is the identity but for rounding errors, which its Cholesky factor removes.
  const Eigen::MatrixXd V = weighted_fields(surface, forms), gram = V.transpose() * V;
  divide_by(gram.llt().matrixU());
  return T;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
