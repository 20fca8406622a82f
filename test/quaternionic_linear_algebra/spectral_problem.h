// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Core>

#include <cmath>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test {

/// \brief K x = N x theta with prescribed eigenvalues and known eigenvectors.
///
/// K = S U diag(values) U^H S with N = S^2 = diag(masses) and a random unitary U.
class Spectral_problem {
 public:
  using Block = CGP::Block<Quaternion<double>>;

  explicit Spectral_problem(Eigen::VectorXd values, std::uint64_t seed = 1)
      : m_values(std::move(values)),
        m_masses((random_numbers(size(), seed).array() + 2).matrix()),
        m_vectors(size(), size()),
        m_duals(size(), size())
  {
    Block A = random_block<Quaternion<double>>(size(), size(), seed + 1);
    for (int j = 0; j < size(); ++j)
      for (int i = 0; i <= j; ++i)
        A(j, i) = i == j ? Quaternion<double>{A(i, i).w, 0, 0, 0} : CGP::conjugate(A(i, j));
    const Block U = CGP::hermitian_eigen_decomposition(A).vectors;
    for (int j = 0; j < size(); ++j)
      for (int i = 0; i < size(); ++i) {
        m_vectors(i, j) = U(i, j) / std::sqrt(m_masses[i]);
        m_duals(i, j) = U(i, j) * std::sqrt(m_masses[i]);
      }
  }

  int size() const { return static_cast<int>(m_values.size()); }
  const Eigen::VectorXd& masses() const { return m_masses; }
  double value(int j) const { return m_values[j]; }
  /// the eigenvectors, N-orthonormal
  const Block& vectors() const { return m_vectors; }

  auto k() const
  {
    return [this](const Block& x) {
      return spectral(m_duals, gram_matrix(m_duals, x), m_values.array());
    };
  }
  auto n() const
  {
    return [this](const Block& x) {
      Block y = x;
      for (Eigen::Index c = 0; c < x.cols(); ++c)
        for (int i = 0; i < size(); ++i) y(i, c) *= m_masses[i];
      return y;
    };
  }
  /// the inverse of K + shift N, of whose eigenvalues those of K are multiplied by the factors
  auto inverse(double shift, const Eigen::VectorXd& factors) const
  {
    const Eigen::ArrayXd inverse = 1 / (factors.cwiseProduct(m_values).array() + shift);
    return [this, inverse](const Block& x) {
      return spectral(m_vectors, gram_matrix(m_vectors, x), inverse);
    };
  }
  /// the inverse of K + shift N
  auto inverse(double shift = 0) const { return inverse(shift, Eigen::VectorXd::Ones(size())); }

  /// sine of the angle from x to the span of the eigenvectors first ... first + count - 1
  double sine(const Block& x, int count = 1, int first = 0) const
  {
    const Block coefficients = gram_matrix(m_duals, x);
    const Eigen::MatrixXd all = real_columns(coefficients);
    Eigen::MatrixXd outside = all;
    outside.middleRows(4 * first, 4 * count).setZero();
    return outside.norm() / all.norm();
  }

 private:
  static Block spectral(const Block& vectors, Block coefficients, const Eigen::ArrayXd& factors)
  {
    for (Eigen::Index c = 0; c < coefficients.cols(); ++c)
      for (Eigen::Index i = 0; i < coefficients.rows(); ++i) coefficients(i, c) *= factors[i];
    return combination(vectors, coefficients);
  }

  Eigen::VectorXd m_values, m_masses;
  Block m_vectors, m_duals;  // N^-1/2 U and N^1/2 U
};

/// 1 2 3 ... n
inline Eigen::VectorXd counting(int n)
{
  return Eigen::VectorXd::LinSpaced(n, 1, n);
}

}  // namespace cgp_test
