// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/direct/Aligned_array.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/Vector_unit.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
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

}  // namespace Conformal_geometry_processing::internal
