// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Harmonic_part.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <utility>

namespace Conformal_geometry_processing::internal {

Harmonic_part::Harmonic_part(const Surface_ref& surface, Eigen::VectorXd w,
                             Eigen::SparseMatrix<double> generators, Eigen::MatrixXd combinations,
                             Eigen::MatrixXd potentials)
    : m_surface(surface),
      m_weights(std::move(w)),
      m_generators(std::move(generators)),
      m_combinations(std::move(combinations)),
      m_potentials(std::move(potentials))
{}

/// A^T b for few columns b. Faster than a product of matrices, which would copy A.
Eigen::MatrixXd products_of_columns(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b)
{
  Eigen::MatrixXd products(A.cols(), b.cols());
  for (Eigen::Index i = 0; i < A.cols(); ++i)
    for (Eigen::Index k = 0; k < b.cols(); ++k) products(i, k) = A.col(i).dot(b.col(k));
  return products;
}

/// A c, likewise
Eigen::MatrixXd sums_of_columns(const Eigen::MatrixXd& A, const Eigen::MatrixXd& c)
{
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(A.rows(), c.cols());
  for (Eigen::Index i = 0; i < A.cols(); ++i)
    for (Eigen::Index k = 0; k < c.cols(); ++k) sums.col(k) += c(i, k) * A.col(i);
  return sums;
}

Eigen::MatrixXd Harmonic_part::coefficients(const Eigen::MatrixXd& alpha) const
{
  const Eigen::MatrixXd weighted = m_weights.asDiagonal() * alpha;
  const Eigen::MatrixXd crossings = m_generators.transpose() * weighted;
  return m_combinations.transpose() * crossings -
         products_of_columns(m_potentials, codifferential(m_surface, m_weights, alpha));
}

Eigen::MatrixXd Harmonic_part::combinations(const Eigen::MatrixXd& c) const
{
  const Eigen::MatrixXd of_generators = m_combinations * c;
  return m_generators * of_generators - differential(m_surface, sums_of_columns(m_potentials, c));
}

}  // namespace Conformal_geometry_processing::internal
