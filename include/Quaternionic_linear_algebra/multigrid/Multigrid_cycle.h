// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>
#include <Quaternionic_linear_algebra/multigrid/Multigrid_level.h>
#include <Quaternionic_linear_algebra/multigrid/Prolongation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief Parameters of a multigrid hierarchy.
struct Multigrid_options {
  /// Connections below this share of the diagonal are ignored
  double strength = 0.03;

  /// Weight of the Jacobi step that smooths the prolongation
  double smoothing = 0.9;

  /// Levels of at most this number of vertices are solved exactly. If this is already the second
  /// level, it saves a fifth of the iterations, but the factor takes as much memory as all the
  /// rest.
  int coarsest_size = 16000;
};

/// \ingroup PkgLinearAlgebra
/// \brief One V-cycle of smoothed aggregation for a real or quaternionic matrix A: a fixed
/// Hermitian positive definite approximation of the inverse of A.
///
/// Aggregates and prolongations are real and computed from the real part of A; the matrices of all
/// levels have the entries of A. All computations, including the exact solution on the coarsest
/// level, use single precision.
///
/// \tparam Entry `float` or `Quaternion<float>`
template <class Entry>
class Multigrid_cycle {
 public:
  using Matrix = Hermitian_sparse_matrix<Entry>;
  using Level = Multigrid_level<Entry>;
  using Coarsest = Supernodal_cholesky<Entry>;

  /// Builds at least one level and the coarsest one
  /// \returns `not_positive_definite` if a diagonal entry or a pivot is not positive on some level
  Solver_status build(Matrix A, const Multigrid_options& options = {});

  /// Releases the memory
  void release();

  /// The levels with smoothing, the finest first; excludes the coarsest one
  const std::vector<Level>& levels() const { return m_levels; }
  const Coarsest& coarsest() const { return m_coarsest; }
  int coarsest_size() const { return static_cast<int>(m_solution.rows()); }

  /// \brief Applies one V-cycle.
  /// \param load load(i, c) writes the four numbers of the right-hand side at vertex i to c
  /// \param store store(i, c) receives the four numbers of the result
  template <class Load, class Store>
  Solver_status apply(Load load, Store store)
  {
    const double scale = greatest(load);
    if (!std::isfinite(scale)) return Solver_status::numerical_issue;
    Level& finest = m_levels.front();
    double c[4];
    // Scales the right-hand side, because the range of single precision is small.
    const double inverse = scale > 0 ? 1 / scale : 0;
    for (int i = 0; i < finest.size(); ++i) {
      load(i, c);
      for (int q = 0; q < 4; ++q) finest.vector(i)[q] = static_cast<float>(c[q] * inverse);
    }
    const Solver_status status = descend(0);
    if (status != Solver_status::success) return status;
    for (int i = 0; i < finest.size(); ++i) {
      for (int q = 0; q < 4; ++q) c[q] = static_cast<double>(finest.vector(i)[q]) * scale;
      store(i, c);
    }
    return status;
  }

  /// Entries of all levels and of the factor, operations of a `build()`, and total memory
  Solver_statistics statistics() const;

 private:
  using Lanes = Vertex_lanes<float>;
  static constexpr int columns = 4 / Scalar_planes<Entry>::size;

  static bool has_positive_diagonal(const Matrix& A);
  static Prolongation make_prolongation(const Matrix& A, const Multigrid_options& options);
  Solver_status factorize_coarsest(const Matrix& A);

  template <class Load>
  double greatest(Load load) const
  {
    double greatest = 0, sum = 0, c[4];
    for (int i = 0; i < m_levels.front().size(); ++i) {
      load(i, c);
      for (int q = 0; q < 4; ++q) greatest = (std::max)(greatest, std::abs(c[q]));
      sum += (c[0] + c[1]) + (c[2] + c[3]);  // propagates NaN, unlike max()
    }
    return std::isfinite(sum) ? greatest : sum;
  }

  float* below(std::size_t l, int I);
  Solver_status descend(std::size_t l);

  // Columns of real systems, or components of quaternions.
  static float& component(Block<float>& x, int i, int q) { return x(i, q); }
  static float& component(Block<Quaternion<float>>& x, int i, int q) { return (&x(i, 0).w)[q]; }

  Solver_status solve_coarsest();

  std::vector<Level> m_levels;
  Coarsest m_coarsest;
  Block<Entry> m_solution;        // on the coarsest level
  Aligned_array<float> m_coarse;  // likewise, with four numbers per vertex
};

}  // namespace Conformal_geometry_processing::internal
