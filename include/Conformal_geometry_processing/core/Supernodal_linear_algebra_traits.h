// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief The sparse Cholesky factorization of this library for CGAL's own packages: a model of
/// `SparseLinearAlgebraTraits_d`, as used by CGAL's parameterization and deformation packages.
///
/// For symmetric positive definite matrices in which CGAL fixes unknowns by rows of the identity:
/// these are eliminated, and their contributions to other rows are moved to the right-hand side. As
/// in CGAL's own traits, every call factorizes the matrix.
/// \cgalModels{SparseLinearAlgebraTraits_d}
class Supernodal_linear_algebra_traits {
  using Sparse = CGAL::Eigen_sparse_matrix<double>::EigenType;

 public:
  using NT = double;
  using Vector = CGAL::Eigen_vector<double>;
  using Matrix = CGAL::Eigen_sparse_matrix<double>;

  /// \brief Solves A x = b.
  /// \param denominator is set to 1
  /// \returns false, with x unchanged, if A is not positive definite or memory is insufficient
  bool linear_solver(const Matrix& A, const Vector& b, Vector& x, NT& denominator)
  {
    denominator = 1;
    const Sparse rows = Sparse(A.eigen_object().transpose());  // a column of this is a row of A
    number_free_rows(rows);
    Hermitian_sparse_matrix<double> lower(pattern_of(rows));
    Eigen::MatrixXd right(m_free.size(), 1), solution;
    for (std::size_t k = 0; k < m_free.size(); ++k) {
      const int i = m_free[k];
      double sum = b[i];
      for (Sparse::InnerIterator a(rows, i); a; ++a) {
        const int j = m_number[static_cast<std::size_t>(a.index())], row = static_cast<int>(k);
        if (j < 0)
          sum -= a.value() * b[a.index()];
        else if (j <= row)
          lower.value(lower.pattern().find(row, j)) = a.value();
      }
      right(static_cast<Eigen::Index>(k), 0) = sum;
    }
    Supernodal_cholesky<double> solver;
    const auto success = Solver_status::success;
    if (solver.analyze(lower.pattern()) != success || solver.factorize(lower, {}) != success ||
        solver.solve(right, solution) != success)
      return false;
    static_cast<Eigen::VectorXd&>(x) = b;  // the assignment of CGAL's own vectors does not compile
    for (std::size_t k = 0; k < m_free.size(); ++k)
      x[m_free[k]] = solution(static_cast<Eigen::Index>(k), 0);
    return true;
  }

 private:
  // A row of the identity matrix fixes its unknown.
  void number_free_rows(const Sparse& rows)
  {
    m_free.clear();
    m_number.assign(static_cast<std::size_t>(rows.cols()), -1);
    for (int i = 0; i < rows.cols(); ++i) {
      bool is_fixed = true;
      for (Sparse::InnerIterator a(rows, i); a; ++a)
        is_fixed = is_fixed && (a.index() == i ? a.value() == 1 : a.value() == 0);
      if (is_fixed) continue;
      m_number[static_cast<std::size_t>(i)] = static_cast<int>(m_free.size());
      m_free.push_back(i);
    }
  }

  std::shared_ptr<const Sparse_pattern> pattern_of(const Sparse& rows) const
  {
    auto pattern = std::make_shared<Sparse_pattern>();
    for (std::size_t k = 0; k < m_free.size(); ++k) {
      pattern->offsets.push_back(pattern->size_of_entries());
      const int column = static_cast<int>(k);
      pattern->indices.push_back(column);
      // The pattern is symmetric, so row k contains the indices of column k, in order.
      for (Sparse::InnerIterator a(rows, m_free[k]); a; ++a)
        if (const int i = m_number[static_cast<std::size_t>(a.index())]; i > column)
          pattern->indices.push_back(i);
    }
    pattern->offsets.push_back(pattern->size_of_entries());
    return pattern;
  }

  std::vector<int> m_free;    // the unknowns that are not fixed
  std::vector<int> m_number;  // their numbers, -1 for the others
};

}  // namespace Conformal_geometry_processing
