// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Aligned_array.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_factor.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_substitution.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_form.h>
#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief Factors A = L L^T for a dense symmetric positive definite matrix of real numbers, in
/// place.
///
/// Uses the kernels of the sparse factorization, to avoid further template instances. The matrix is
/// one panel of `Front_kernels` for the `vector_unit()` at the time of `set_zero()`; entries above
/// the diagonal are never read. n^2 numbers, n^3 / 3 operations, 2 n^2 for a solution.
class Dense_cholesky {
 public:
  /// Resizes the matrix and sets it to zero
  void set_zero(int size)
  {
    m_size = size;
    m_kernels = kernels_for<double>(1);
    m_panel.resize(layout().panel_size(size, 0));
    std::fill_n(m_panel.data(), m_panel.size(), 0.);
  }

  int size() const { return m_size; }

  /// \brief An entry of the matrix, or of the factor after `factorize()`.
  /// \pre 0 <= column < size(), 0 <= row < size()
  double& operator()(int row, int column)
  {
    return m_panel.data()[layout().in_panel(m_size, row, column)];
  }
  double operator()(int row, int column) const
  {
    return m_panel.data()[layout().in_panel(m_size, row, column)];
  }

  /// \returns whether the matrix is positive definite; if not, its values are destroyed
  bool factorize() { return m_kernels.factor_panel(m_panel.data(), m_size, blocks()) < 0; }

  /// \brief Overwrites the right-hand side x by the solution.
  /// \pre the matrix is factorized, and x has its size
  void solve(Eigen::VectorXd& x) const
  {
    Eigen::VectorXd y =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(blocks()) * layout().lanes());
    y.head(m_size) = x;
    for (int b = 0; b < blocks(); ++b) forward(b, y.data());
    for (int b = blocks() - 1; b >= 0; --b) backward(b, y.data());
    x = y.head(m_size);
  }

  /// Releases the memory
  void release() { set_zero(0); }

  double bytes() const { return static_cast<double>(m_panel.size()) * sizeof(double); }

 private:
  const Panel_layout& layout() const { return m_kernels.layout; }
  int blocks() const { return layout().blocks(m_size); }

  // The rows of a block in one column.
  const double* block(int b, int column) const
  {
    return m_panel.data() + (static_cast<std::int64_t>(b) * m_size + column) * layout().lanes();
  }

  // Solves the rows of block b of L y = x, after the previous ones.
  void forward(int b, double* x) const
  {
    const int lanes = layout().lanes();
    double* const y = x + b * lanes;
    const int first = b * lanes, end = (std::min)(first + lanes, m_size);
    for (int j = 0; j < end; ++j) {
      const double* const L = block(b, j);
      if (j >= first) x[j] /= L[j - first];
      for (int l = (std::max)(0, j - first + 1); l < lanes; ++l) y[l] -= L[l] * x[j];
    }
  }

  // Solves the rows of block b of L^T x = y, after the later ones, and eliminates them from the
  // previous ones.
  void backward(int b, double* x) const
  {
    const int lanes = layout().lanes();
    double* const y = x + b * lanes;
    const int first = b * lanes, end = (std::min)(first + lanes, m_size);
    for (int j = end - 1; j >= 0; --j) {
      const double* const L = block(b, j);
      for (int l = (std::max)(0, j - first + 1); l < lanes; ++l) x[j] -= L[l] * y[l];
      if (j >= first) x[j] /= L[j - first];
    }
  }

  int m_size = 0;
  Front_kernels<double> m_kernels = kernels_for<double>(1);
  Aligned_array<double> m_panel;
};

/// \brief The dense real Schur complement of the reduced rows after elimination of all others:
/// B^T S B with the quaternionic Schur complement S, two coordinates for every row.
///
/// Filled by `assemble()`, then by `add()`; rows are in elimination order. The quaternionic
/// complement is read from the updates of the factor, without a copy.
class Reduced_complement {
  using Scalar = Quaternion<double>;

 public:
  Reduced_complement(const Reduced_complement&) = delete;
  Reduced_complement& operator=(const Reduced_complement&) = delete;

  /// \param structure keeps the reduced rows
  Reduced_complement(const Sparse_pattern& pattern, const Supernodal_structure& structure)
      : m_eliminated(structure.size_of_columns() - structure.size_of_kept()),
        m_kept(structure.order().begin() + m_eliminated, structure.order().end())
  {
    const std::vector<int> place = inverse_permutation(structure.order());
    for (int j : m_kept)
      for (int k = pattern.offsets[at(j)]; k < pattern.offsets[at(j) + 1]; ++k) {
        const int row = place[at(pattern.indices[at(k)])] - m_eliminated;
        if (row >= 0) m_entries.push_back({k, row, place[at(j)] - m_eliminated});
      }
  }

  /// Sets the matrix to the entries of B^T (X + diag(shift)) B
  void assemble(const Hermitian_sparse_matrix<Scalar>& X, const Eigen::VectorXd& shift,
                const Reduced_basis<double>& basis)
  {
    m_planes.clear();
    for (int i : m_kept) m_planes.push_back({basis.vector(i, 0), basis.vector(i, 1)});
    const int size = 2 * static_cast<int>(m_kept.size());
    m_matrix.set_zero(size);
    for (const auto& [source, row, column] : m_entries) {
      const Scalar& x = X.value(source);
      if (row >= column)
        add(row, column, x);
      else
        add(column, row, conjugate(x));
    }
    if (shift.size() > 0)
      for (int k = 0; k < size; ++k) m_matrix(k, k) += shift[m_kept[at(k / 2)]];
  }

  /// Adds the contribution of the elimination of all other rows
  void add(const Supernodal_factor<Scalar, double>& factor)
  {
    for (int s = 0; s < factor.structure().size(); ++s)
      if (factor.structure().parent(s) < 0) add(factor, s);
  }

  /// \returns whether the matrix is positive definite
  bool factorize() { return m_matrix.factorize(); }

  /// Releases the memory of the matrix and its factor
  void release() { m_matrix.release(); }

  /// Replaces the last rows of y, in elimination order: right-hand sides by solutions
  void solve(Vector<Scalar>& y) const
  {
    if (m_kept.empty()) return;
    Eigen::VectorXd c(m_matrix.size());
    for (std::size_t k = 0; k < m_kept.size(); ++k)
      for (std::size_t p = 0; p < 2; ++p)
        c[index(k, p)] = dot(m_planes[k][p], y[m_eliminated + static_cast<Eigen::Index>(k)]);
    m_matrix.solve(c);
    for (std::size_t k = 0; k < m_kept.size(); ++k)
      y[m_eliminated + static_cast<Eigen::Index>(k)] =
          m_planes[k][0] * c[index(k, 0)] + m_planes[k][1] * c[index(k, 1)];
  }

  std::int64_t factor_entries() const
  {
    const std::int64_t n = 2 * static_cast<std::int64_t>(m_kept.size());
    return n * (n + 1) / 2;
  }
  double flops() const
  {
    const double n = 2. * static_cast<double>(m_kept.size());
    return n * n * n / 3;
  }
  double bytes() const
  {
    const double n = 2. * static_cast<double>(m_kept.size());
    return n * n * sizeof(double);
  }

 private:
  // Position in the pattern, and the rows of the matrix; column > row is possible at this stage.
  struct Entry {
    int source, row, column;
  };

  static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }
  static Eigen::Index index(std::size_t k, std::size_t p)
  {
    return static_cast<Eigen::Index>(2 * k + p);
  }

  // Adds the lower triangle of the update of a supernode.
  void add(const Supernodal_factor<Scalar, double>& factor, int s)
  {
    const Panel_layout& layout = factor.layout();
    const int* const rows = factor.structure().rows(s);
    const int height = factor.structure().height(s);
    const int blocks = layout.blocks(height), lanes = layout.lanes();
    for (int j = 0; j < height; ++j)
      for (int i = j; i < height; ++i) {
        const double* const x = factor.update(s) + layout.in_update(blocks, i, j);
        add(rows[i] - m_eliminated, rows[j] - m_eliminated,
            {x[0], x[lanes], x[2 * lanes], x[3 * lanes]});
      }
  }

  // Adds a block of two real rows and columns; the upper part of diagonal blocks is not used.
  void add(int row, int column, const Scalar& x)
  {
    const auto &from = m_planes[at(column)], &to = m_planes[at(row)];
    for (int c = 0; c < 2; ++c) {
      const Scalar image = x * from[at(c)];
      for (int r = 0; r < 2; ++r) m_matrix(2 * row + r, 2 * column + c) += dot(to[at(r)], image);
    }
  }

  int m_eliminated = 0;
  std::vector<int> m_kept;
  std::vector<Entry> m_entries;
  std::vector<std::array<Scalar, 2>> m_planes;
  Dense_cholesky m_matrix;
};

/// \brief Solves with R = B^T (X + diag(shift)) B by eliminating the unreduced rows first, as
/// quaternions, and the reduced ones last, as real numbers.
///
/// The Schur complement of the reduced rows is a dense quaternionic matrix; restricted to their
/// planes it becomes a dense real one of twice their number, which is factored as such. The best
/// choice if the boundary is short, as for a disk. For all functions see
/// `Reduced_hermitian_solver`.
class Schur_reduced_solver {
 public:
  using FT = double;
  using Scalar = Quaternion<FT>;

  /// \param order of all rows; the reduced ones are moved to its end
  Solver_status analyze(const Sparse_pattern& pattern, const Reduced_rows& rows,
                        const Ordering& order)
  {
    return internal::guarded([&] {
      m_factor.reset();
      m_is_factorized = false;
      if (pattern.size() == 0 || rows.size() != pattern.size() ||
          order.size() != pattern.offsets.size() - 1 || inverse_permutation(order).empty())
        return Solver_status::wrong_state;
      auto structure = std::make_shared<const Supernodal_structure>(
          pattern, reduced_last(order, rows), rows.size_of_reduced());
      m_rows = rows;
      m_entries = pattern.size_of_entries();
      m_complement.emplace(pattern, *structure);
      m_factor.emplace(std::move(structure));
      return Solver_status::success;
    });
  }

  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& X, const Vector<FT>& shift,
                          const Reduced_basis<FT>& basis)
  {
    return internal::guarded([&] {
      if (!m_factor || X.size() != m_rows.size() || X.pattern().size_of_entries() != m_entries ||
          basis.rows() != m_rows || (shift.size() != 0 && shift.size() != X.size()))
        return Solver_status::wrong_state;
      m_is_factorized = false;
      if (!is_finite(X) || !shift.allFinite()) return Solver_status::numerical_issue;
      m_complement->assemble(X, shift, basis);
      if (m_factor->factorize(X, shift) >= 0) return Solver_status::not_positive_definite;
      m_complement->add(*m_factor);
      if (!m_complement->factorize()) return Solver_status::not_positive_definite;
      m_is_factorized = true;
      return Solver_status::success;
    });
  }

  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return internal::guarded([&] {
      if (!m_is_factorized || b.rows() != m_rows.size()) return Solver_status::wrong_state;
      const Ordering& order = m_factor->structure().order();
      Substitution substitution(*m_factor);
      Block<Scalar> solution(b.rows(), b.cols());
      Vector<Scalar> y(b.rows());
      for (Eigen::Index c = 0; c < b.cols(); ++c) {
        for (Eigen::Index k = 0; k < y.size(); ++k) y[k] = b(order[at(k)], c);
        FT* const numbers = reinterpret_cast<FT*>(y.data());
        substitution.forward(numbers);
        m_complement->solve(y);
        substitution.backward(numbers);
        for (Eigen::Index k = 0; k < y.size(); ++k) solution(order[at(k)], c) = y[k];
        if (!components(y).allFinite()) return Solver_status::numerical_issue;
      }
      x = std::move(solution);
      return Solver_status::success;
    });
  }

  void release()
  {
    m_is_factorized = false;
    if (m_factor) m_factor->release();
    if (m_complement) m_complement->release();
  }

  /// Cost of both factors, in real numbers
  Solver_statistics statistics() const
  {
    Solver_statistics s;
    if (!m_factor) return s;
    s.factor_entries = 4 * m_factor->structure().stored_entries() + m_complement->factor_entries();
    s.flops = 16 * m_factor->structure().operations() + m_complement->flops();
    s.bytes = static_cast<double>(m_factor->bytes()) + m_complement->bytes();
    return s;
  }

 private:
  using Factor = Supernodal_factor<Scalar, FT>;
  using Substitution = Supernodal_substitution<Scalar, FT>;

  static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

  static bool is_finite(const Hermitian_sparse_matrix<Scalar>& X)
  {
    bool is_finite = true;
    X.for_each_entry([&](int, int, const Scalar& x) {
      is_finite = is_finite && std::isfinite(squared_norm(x));
    });
    return is_finite;
  }

  Reduced_rows m_rows;
  int m_entries = 0;
  std::optional<Factor> m_factor;
  std::optional<Reduced_complement> m_complement;
  bool m_is_factorized = false;
};

}  // namespace Conformal_geometry_processing::internal
