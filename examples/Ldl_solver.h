// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace CGP = Conformal_geometry_processing;

/// A linear solver of one file, and a model of SparseHermitianSolver: P A P^T = L D L^H, row by
/// row, ordered by Eigen's minimum degree. Nothing in it asks whether scalars commute.
//! [solver]
template <class Scalar_>
class Ldl_solver {
 public:
  using Scalar = Scalar_;
  using FT = double;
  using Status = CGP::Solver_status;
  using Pattern = CGP::Sparse_pattern;
  using Matrix = CGP::Hermitian_sparse_matrix<Scalar>;
  using Vector = CGP::Vector<Scalar>;
  using Block = CGP::Block<Scalar>;

  Status analyze(const Pattern& pattern) { return analyze(pattern, minimum_degree(pattern)); }

  Status analyze_with_positions(const Pattern& pattern, const Eigen::Matrix3Xd&)
  {
    return analyze(pattern);
  }

  template <class Other>
  Status analyze_like(const Pattern& pattern, const Other& other)
  {
    return analyze(pattern, other.ordering());
  }

  Status analyze(const Pattern& pattern, const std::vector<int>& order)
  {
    m_factorized = false;
    m_order.clear();
    m_entries = pattern.size_of_entries();
    if (pattern.size() == 0 || !number(order, pattern.size())) return Status::wrong_state;
    m_order = order;
    sort_entries(pattern);
    find_tree();
    return Status::success;
  }

  const std::vector<int>& ordering() const { return m_order; }

  Status factorize(const Matrix& A, const Eigen::VectorXd& shift)
  {
    if (m_order.empty() || A.size() != size() || A.pattern().size_of_entries() != m_entries ||
        (shift.size() != 0 && shift.size() != size()))
      return Status::wrong_state;
    m_factorized = false;
    m_rows.resize(m_starts.back());
    m_values.resize(m_starts.back());
    m_pivots.resize(size());
    std::vector<int> ends(m_starts.begin(), m_starts.end() - 1), seen(m_order.size(), -1);
    Vector y = Vector::Constant(size(), Scalar{});
    for (int k = 0; k < size(); ++k) {
      double pivot = A.diagonal(m_order[k]) + (shift.size() ? shift[m_order[k]] : 0);
      for (const int i : row_of_factor(k, A, y, seen)) {
        const Scalar y_i = y[i];
        y[i] = Scalar{};
        for (int p = m_starts[i]; p < ends[i]; ++p) y[m_rows[p]] -= m_values[p] * y_i;
        m_rows[ends[i]] = k;
        m_values[ends[i]] = CGP::conjugate(y_i) * (1 / m_pivots[i]);
        pivot -= real(m_values[ends[i]++] * y_i);
      }
      if (!std::isfinite(pivot)) return Status::numerical_issue;
      if (pivot <= 0) return Status::not_positive_definite;
      m_pivots[k] = pivot;
    }
    m_factorized = true;
    return Status::success;
  }

  Status solve(const Block& b, Block& x) const
  {
    if (!m_factorized || b.rows() != size()) return Status::wrong_state;
    Block y(b.rows(), b.cols());
    for (int k = 0; k < size(); ++k) y.row(k) = b.row(m_order[k]);
    for (Eigen::Index c = 0; c < b.cols(); ++c) {
      for (int k = 0; k < size(); ++k)
        for (int p = m_starts[k]; p < m_starts[k + 1]; ++p)
          y(m_rows[p], c) -= m_values[p] * y(k, c);
      for (int k = size() - 1; k >= 0; --k) {
        y(k, c) = y(k, c) * (1 / m_pivots[k]);
        for (int p = m_starts[k]; p < m_starts[k + 1]; ++p)
          y(k, c) -= CGP::conjugate(m_values[p]) * y(m_rows[p], c);
      }
    }
    x.resize(b.rows(), b.cols());
    for (int k = 0; k < size(); ++k) x.row(m_order[k]) = y.row(k);
    return Status::success;
  }

  CGP::Solver_statistics statistics() const
  {
    CGP::Solver_statistics s;
    for (int k = 0; k < size(); ++k) {
      const double column = m_starts[k + 1] - m_starts[k];
      s.factor_entries += m_starts[k + 1] - m_starts[k] + 1;
      s.flops += (1 + column * (column + 3)) * sizeof(Scalar) / sizeof(double);
    }
    s.bytes = static_cast<double>(s.factor_entries) * sizeof(Scalar);
    return s;
  }
  //! [solver]

 private:
  struct Entry {
    int i;           // its row in elimination order; its column is larger
    int position;    // in the pattern
    bool is_stored;  // or its conjugate is
  };

  int size() const { return static_cast<int>(m_order.size()); }
  static double real(double s) { return s; }
  static double real(const CGP::Quaternion<double>& q) { return q.w; }

  static std::vector<int> minimum_degree(const Pattern& pattern)
  {
    std::vector<Eigen::Triplet<double>> ones;
    for (int j = 0; j < pattern.size(); ++j)
      for (int k = pattern.offsets[j]; k < pattern.offsets[j + 1]; ++k)
        ones.emplace_back(pattern.indices[k], j, 1);
    Eigen::SparseMatrix<double> graph(pattern.size(), pattern.size());
    graph.setFromTriplets(ones.begin(), ones.end());
    Eigen::AMDOrdering<int>::PermutationType order(pattern.size());
    if (pattern.size() > 0) Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
    return {order.indices().data(), order.indices().data() + pattern.size()};
  }

  // The inverse of the order; false if it is not a permutation.
  bool number(const std::vector<int>& order, int n)
  {
    m_new.assign(n, -1);
    for (int k = 0; k < static_cast<int>(order.size()); ++k)
      if (order[k] >= 0 && order[k] < n) m_new[order[k]] = k;
    return static_cast<int>(order.size()) == n &&
           std::find(m_new.begin(), m_new.end(), -1) == m_new.end();
  }

  void sort_entries(const Pattern& pattern)
  {
    m_columns.assign(m_order.size(), {});
    for (int j = 0; j < size(); ++j)
      for (int k = pattern.offsets[j] + 1; k < pattern.offsets[j + 1]; ++k) {
        const int a = m_new[pattern.indices[k]], b = m_new[j];
        m_columns[std::max(a, b)].push_back({std::min(a, b), k, a < b});
      }
  }

  // The elimination tree, in which the rows of L are subtrees, and the columns' sizes.
  void find_tree()
  {
    m_parent.assign(m_order.size(), -1);
    m_starts.assign(m_order.size() + 1, 0);
    std::vector<int> seen(m_order.size(), -1);
    for (int k = 0; k < size(); ++k) {
      seen[k] = k;
      for (const Entry& e : m_columns[k])
        for (int i = e.i; seen[i] != k; i = m_parent[i]) {
          if (m_parent[i] < 0) m_parent[i] = k;
          ++m_starts[i + 1];
          seen[i] = k;
        }
    }
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
  }

  // The columns that meet row k of L, ascending; y gets the values of A above its diagonal.
  std::vector<int> row_of_factor(int k, const Matrix& A, Vector& y, std::vector<int>& seen) const
  {
    std::vector<int> row;
    seen[k] = k;
    for (const Entry& e : m_columns[k]) {
      y[e.i] = e.is_stored ? A.value(e.position) : CGP::conjugate(A.value(e.position));
      for (int i = e.i; seen[i] != k; i = m_parent[i]) {
        seen[i] = k;
        row.push_back(i);
      }
    }
    std::sort(row.begin(), row.end());
    return row;
  }

  std::vector<int> m_order, m_new, m_parent, m_starts, m_rows;
  std::vector<std::vector<Entry>> m_columns;
  std::vector<Scalar> m_values;
  std::vector<double> m_pivots;
  int m_entries = 0;
  bool m_factorized = false;
};

//! [traits]
struct Ldl_solver_traits {
  template <class Scalar>
  using Solver = Ldl_solver<Scalar>;
};
//! [traits]
