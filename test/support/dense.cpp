// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/dense.h"

#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

namespace cgp_test {

Quaternion_matrix zero_matrix(int rows, int cols)
{
  return Quaternion_matrix::Constant(rows, cols, Quaternion<double>{});
}

Quaternion_matrix dense(
    const Conformal_geometry_processing::internal::Quaternionic_sparse_matrix<double>& A)
{
  Quaternion_matrix M = zero_matrix(A.rows(), A.cols());
  for (int f = 0; f < A.rows(); ++f)
    for (int c = 0; c < 3; ++c) M(f, A.column(f, c)) += A.value(f, c);
  return M;
}

Quaternion_matrix adjoint_product(const Quaternion_matrix& A, const Eigen::VectorXd& m,
                                  const Quaternion_matrix& B)
{
  Quaternion_matrix M = zero_matrix(static_cast<int>(A.cols()), static_cast<int>(B.cols()));
  for (Eigen::Index f = 0; f < A.rows(); ++f)
    for (Eigen::Index i = 0; i < A.cols(); ++i) {
      if (A(f, i) == Quaternion<double>{}) continue;
      for (Eigen::Index j = 0; j < B.cols(); ++j) M(i, j) += m[f] * (conjugate(A(f, i)) * B(f, j));
    }
  return M;
}

double greatest_entry(const Quaternion_matrix& A)
{
  double greatest = 0;
  for (Eigen::Index k = 0; k < A.size(); ++k) greatest = std::max(greatest, norm(A.data()[k]));
  return greatest;
}

double relative_difference(const Quaternion_matrix& A, const Quaternion_matrix& B)
{
  return greatest_entry(A - B) / greatest_entry(B);
}

double hermitian_defect(const Quaternion_matrix& A)
{
  double defect = 0;
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    for (Eigen::Index j = 0; j < A.cols(); ++j)
      defect = std::max(defect, norm(A(i, j) - conjugate(A(j, i))));
  return defect / greatest_entry(A);
}

Eigen::MatrixXd real_part(const Quaternion_matrix& A)
{
  Eigen::MatrixXd M(A.rows(), A.cols());
  for (Eigen::Index k = 0; k < A.size(); ++k) M.data()[k] = A.data()[k].w;
  return M;
}

Eigen::MatrixXd real_form(const Quaternion_matrix& A)
{
  Eigen::MatrixXd M(4 * A.rows(), 4 * A.cols());
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      M.block<4, 4>(4 * i, 4 * j) = Conformal_geometry_processing::real_block(A(i, j));
  return M;
}

double greatest_difference(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b)
{
  return greatest_entry(a - b);
}

Quaternion_vector<double> imaginary_columns(const Eigen::Matrix3Xd& v)
{
  Quaternion_vector<double> q(v.cols());
  for (Eigen::Index i = 0; i < v.cols(); ++i) q[i] = {0, v(0, i), v(1, i), v(2, i)};
  return q;
}

}  // namespace cgp_test
