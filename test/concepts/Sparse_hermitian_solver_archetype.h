// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <Eigen/Dense>

#include <numeric>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test {

/// A minimal model of the concept SparseHermitianSolver: dense, neither copyable nor movable.
template <class Scalar_>
class Sparse_hermitian_solver_archetype {
 public:
  using Scalar = Scalar_;
  using FT = double;

  Sparse_hermitian_solver_archetype() = default;
  Sparse_hermitian_solver_archetype(const Sparse_hermitian_solver_archetype&) = delete;
  Sparse_hermitian_solver_archetype(Sparse_hermitian_solver_archetype&&) = delete;
  Sparse_hermitian_solver_archetype& operator=(const Sparse_hermitian_solver_archetype&) = delete;
  Sparse_hermitian_solver_archetype& operator=(Sparse_hermitian_solver_archetype&&) = delete;

  CGP::Solver_status analyze(const CGP::Sparse_pattern& pattern)
  {
    CGP::internal::Ordering order(at(pattern.size()));
    std::iota(order.begin(), order.end(), 0);
    return analyze(pattern, order);
  }

  CGP::Solver_status analyze_with_positions(const CGP::Sparse_pattern& pattern,
                                            const Eigen::Matrix3Xd&)
  {
    return analyze(pattern);
  }

  template <class Other>
  CGP::Solver_status analyze_like(const CGP::Sparse_pattern& pattern, const Other& other)
  {
    return analyze(pattern, other.ordering());
  }

  CGP::Solver_status analyze(const CGP::Sparse_pattern& pattern,
                             const CGP::internal::Ordering& order)
  {
    m_analyzed = pattern.size() > 0 && at(pattern.size()) == order.size();
    m_ordering = order;
    return m_analyzed ? CGP::Solver_status::success : CGP::Solver_status::wrong_state;
  }

  const CGP::internal::Ordering& ordering() const { return m_ordering; }

  CGP::Solver_status factorize(const CGP::Hermitian_sparse_matrix<Scalar>& A,
                               const CGP::Vector<FT>& shift)
  {
    if (!m_analyzed || at(A.size()) != m_ordering.size() ||
        (shift.size() != 0 && shift.size() != A.size()))
      return CGP::Solver_status::wrong_state;
    const Eigen::MatrixXd D = shift.size() == 0 ? real_form(A) : real_form(plus_diagonal(A, shift));
    m_factorized = false;
    if (!D.allFinite()) return CGP::Solver_status::numerical_issue;
    m_llt.compute(D);
    m_factorized = m_llt.info() == Eigen::Success;
    return m_factorized ? CGP::Solver_status::success : CGP::Solver_status::not_positive_definite;
  }

  CGP::Solver_status solve(const CGP::Block<Scalar>& b, CGP::Block<Scalar>& x) const
  {
    if (!m_factorized || at(static_cast<int>(b.rows())) != m_ordering.size())
      return CGP::Solver_status::wrong_state;
    const Eigen::MatrixXd solution = m_llt.solve(real_columns(b));
    x.resize(b.rows(), b.cols());
    std::copy(solution.data(), solution.data() + solution.size(),
              reinterpret_cast<double*>(x.data()));
    return CGP::Solver_status::success;
  }

  CGP::Solver_statistics statistics() const
  {
    const auto n = static_cast<std::int64_t>(m_ordering.size());
    const double bytes = static_cast<double>(n * n) * sizeof(Scalar);
    return {n * (n + 1) / 2, static_cast<double>(n * n * n), bytes};
  }

 private:
  CGP::internal::Ordering m_ordering;
  Eigen::LLT<Eigen::MatrixXd> m_llt;
  bool m_analyzed = false, m_factorized = false;
};

/// A minimal model of the concept SparseHermitianSolverTraits.
struct Sparse_hermitian_solver_traits_archetype {
  template <class Scalar>
  using Solver = Sparse_hermitian_solver_archetype<Scalar>;
};

}  // namespace cgp_test
