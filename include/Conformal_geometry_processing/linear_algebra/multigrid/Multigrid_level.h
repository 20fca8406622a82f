// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Aligned_array.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Prolongation.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Vertex_lanes.h>

#include <cstddef>
#include <cstdint>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief One level of a multigrid hierarchy: a matrix A, the prolongation from the next coarser
/// level, and Gauss-Seidel smoothing before and after the coarse-grid correction.
///
/// The two sweeps run in opposite directions, so that for every Hermitian positive definite coarse
/// correction the cycle is Hermitian, and positive definite as long as the diagonal of A is
/// positive (even if rounding has made A indefinite). Only the lower triangle is stored; each sweep
/// traverses it once and uses every entry for its conjugate transpose as well.
///
/// Vectors have four numbers per vertex (`Vertex_lanes`).
/// \tparam Entry `float` or `Quaternion<float>`
template <class Entry>
class Multigrid_level {
 public:
  using Matrix = Hermitian_sparse_matrix<Entry>;

  /// \pre the diagonal of A is positive
  Multigrid_level(Matrix A, Prolongation P);

  int size() const { return m_matrix.size(); }
  const Matrix& matrix() const { return m_matrix; }
  const Prolongation& prolongation() const { return m_prolongation; }

  /// The four numbers of vertex i: the right-hand side before the cycle, the solution after it
  float* vector(int i) { return m_vectors.data() + std::ptrdiff_t(stride) * i; }
  const float* vector(int i) const { return m_vectors.data() + std::ptrdiff_t(stride) * i; }

  /// Computes x = (D + L^H)^-1 b, which overwrites b, and the residual r = b - A x = -L x; L is the
  /// strictly lower triangle
  void smooth_first();

  /// Calls visit(I, c) with contributions c to the four numbers of (P^T r)_I, which are to be added
  template <class Visitor>
  void restrict_residual(Visitor visit)
  {
    for (int i = 0; i < size(); ++i) {
      Register r;
      Lanes::load(residual(i), r);
      m_prolongation.for_each_in_row(i,
                                     [&](int I, float weight) { visit(I, Register(weight * r)); });
    }
  }

  /// \brief Adds the coarse-grid correction, x + P c, where c(I) points to its four numbers at I,
  /// and smooths by the adjoint sweep: x := (D + L)^-1 (b - L^H (x + P c)) = (D + L)^-1 (D x - L^H
  /// P c).
  template <class Correction>
  void correct_and_smooth(Correction c)
  {
    for (int i = 0; i < size(); ++i) {
      Register x, e = {};
      Lanes::load(vector(i), x);
      m_prolongation.for_each_in_row(i, [&](int I, float weight) {
        Register ci;
        Lanes::load(c(I), ci);
        e += weight * ci;
      });
      x *= m_matrix.diagonal(i);
      Lanes::store(vector(i), x);
      Lanes::store(residual(i), e);
    }
    smooth_last();
  }

  std::int64_t bytes() const;

 private:
  using Lanes = Vertex_lanes<float>;
  using Register = Lanes::Register;
  static constexpr int stride = 8;  // vector and residual are adjacent, to be loaded together

  int begin(int j) const { return m_matrix.pattern().offsets[static_cast<std::size_t>(j)]; }
  int row(int k) const { return m_matrix.pattern().indices[static_cast<std::size_t>(k)]; }
  float* residual(int i) { return vector(i) + 4; }

  void smooth_last();

  Matrix m_matrix;
  Prolongation m_prolongation;
  Aligned_array<float> m_vectors;  // 4 + 4 numbers per vertex
};

}  // namespace Conformal_geometry_processing::internal
