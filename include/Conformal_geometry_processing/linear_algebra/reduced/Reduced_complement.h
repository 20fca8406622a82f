// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Reduced_basis.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Dense_cholesky.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_factor.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
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

}  // namespace Conformal_geometry_processing::internal
