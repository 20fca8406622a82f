// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_MULTIGRID_CYCLE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_MULTIGRID_CYCLE_H

#include <Conformal_geometry_processing/linear_algebra/direct/Scalar_planes.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_cholesky.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_level.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/galerkin_product.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief how a hierarchy is built.
struct Multigrid_options {
  /// connections below this share of the diagonal do not count
  double strength = 0.03;

  /// the weight of the Jacobi step that smooths the prolongation
  double smoothing = 0.9;

  /// levels of at most so many vertices are solved exactly. Where that is the second level already,
  /// a fifth of the iterations is saved, but the factor takes as much memory as all the rest.
  int coarsest_size = 16000;
};

/// \ingroup PkgLinearAlgebra
/// \brief one V-cycle of smoothed aggregation for a real or quaternionic matrix A: a fixed
/// Hermitian positive definite operator, close to the inverse of A.
///
/// Aggregates and prolongations are real, made from the real part of A; the matrices of all levels
/// have the entries of A. All in single precision, the exact solution on the coarsest level as
/// well.
///
/// \tparam Entry `float` or `Quaternion<float>`
template <class Entry>
class Multigrid_cycle {
 public:
  using Matrix = Hermitian_sparse_matrix<Entry>;
  using Level = Multigrid_level<Entry>;
  using Coarsest = Supernodal_cholesky<Entry, float>;

  /// builds at least one level and the coarsest one
  /// \returns `not_positive_definite` where a diagonal entry or a pivot is not positive on some
  /// level
  Solver_status build(Matrix A, const Multigrid_options& options = {})
  {
    release();
    do {
      if (!has_positive_diagonal(A)) return Solver_status::not_positive_definite;
      Prolongation P = make_prolongation(A, options);
      Matrix coarse = galerkin_product(A, P);
      m_levels.emplace_back(std::move(A), std::move(P));
      A = std::move(coarse);
    } while (A.size() > options.coarsest_size);
    return factorize_coarsest(A);
  }

  /// gives the memory back
  void release()
  {
    m_levels.clear();
    m_coarsest.release();
    m_solution.resize(0, columns);
    m_coarse.resize(0);
  }

  /// the levels that are smoothed, the finest first; the coarsest is not among them
  const std::vector<Level>& levels() const { return m_levels; }
  const Coarsest& coarsest() const { return m_coarsest; }
  int coarsest_size() const { return static_cast<int>(m_solution.rows()); }

  /// \brief one V-cycle.
  /// \param load load(i, c) writes the four numbers of the right-hand side at vertex i to c
  /// \param store store(i, c) takes the four numbers of the result
  template <class Load, class Store>
  Solver_status apply(Load load, Store store)
  {
    const double scale = greatest(load);
    if (!std::isfinite(scale)) return Solver_status::numerical_issue;
    Level& finest = m_levels.front();
    double c[4];
    // Single precision has a small range, a right-hand side may have any size.
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

  /// the entries of all levels and of the factor, the operations of a `build()` and all memory
  Solver_statistics statistics() const
  {
    Solver_statistics s;
    if (coarsest_size() > 0) s = m_coarsest.statistics();
    s.bytes += sizeof(float) * 2. * static_cast<double>(m_coarse.size());
    for (const Level& level : m_levels) {
      const double entries = level.matrix().pattern().size_of_entries();
      const double weights = static_cast<double>(level.prolongation().columns.size());
      s.factor_entries += level.matrix().pattern().size_of_entries();
      s.bytes += static_cast<double>(level.bytes());
      // Every entry is multiplied by the weights of its two rows.
      s.flops += 2 * Scalar_planes<Entry>::size * entries * std::pow(weights / level.size(), 2);
    }
    return s;
  }

 private:
  using Lanes = Vertex_lanes<float>;
  static constexpr int columns = 4 / Scalar_planes<Entry>::size;

  static bool has_positive_diagonal(const Matrix& A)
  {
    bool is_positive = true;
    for (int i = 0; i < A.size(); ++i) is_positive = is_positive && A.diagonal(i) > 0;
    return is_positive;
  }

  static Prolongation make_prolongation(const Matrix& A, const Multigrid_options& options)
  {
    const Connection_graph graph = strong_connections(A, options.strength);
    return smoothed_prolongation(graph, aggregate(graph), options.smoothing);
  }

  Solver_status factorize_coarsest(const Matrix& A)
  {
    m_solution.resize(A.size(), columns);
    m_coarse.resize(std::int64_t(4) * A.size());
    if (A.size() == 0) return Solver_status::success;
    Solver_status status = m_coarsest.analyze(A.pattern());
    if (status == Solver_status::success) status = m_coarsest.factorize(A, {});
    if (status != Solver_status::not_positive_definite) return status;
    // Rounding spoils definiteness where A is nearly singular. A diagonal larger by a millionth
    // mends that, and makes little difference to a preconditioner.
    Vector<float> more(A.size());
    for (int i = 0; i < A.size(); ++i) more[i] = 1e-6f * A.diagonal(i);
    return m_coarsest.factorize(A, more);
  }

  template <class Load>
  double greatest(Load load) const
  {
    double greatest = 0, sum = 0, c[4];
    for (int i = 0; i < m_levels.front().size(); ++i) {
      load(i, c);
      for (int q = 0; q < 4; ++q) greatest = (std::max)(greatest, std::abs(c[q]));
      sum += (c[0] + c[1]) + (c[2] + c[3]);  // max() loses what is not a number
    }
    return std::isfinite(sum) ? greatest : sum;
  }

  // The four numbers of vertex I one level below l.
  float* below(std::size_t l, int I)
  {
    return l + 1 < m_levels.size() ? m_levels[l + 1].vector(I)
                                   : m_coarse.data() + std::ptrdiff_t(4) * I;
  }

  Solver_status descend(std::size_t l)
  {
    using Register = Lanes::Register;
    Level& level = m_levels[l];
    level.smooth_first();
    for (int I = 0; I < level.prolongation().coarse_size; ++I)
      Lanes::store(below(l, I), Register{});
    level.restrict_residual([&](int I, const Register& part) {
      Register sum;
      Lanes::load(below(l, I), sum);
      sum += part;
      Lanes::store(below(l, I), sum);
    });
    const Solver_status status = l + 1 < m_levels.size() ? descend(l + 1) : solve_coarsest();
    level.correct_and_smooth([&](int I) { return below(l, I); });
    return status;
  }

  // Columns of real systems, and components of quaternions.
  static float& component(Block<float>& x, int i, int q) { return x(i, q); }
  static float& component(Block<Quaternion<float>>& x, int i, int q) { return (&x(i, 0).w)[q]; }

  Solver_status solve_coarsest()
  {
    const int size = coarsest_size();
    if (size == 0) return Solver_status::success;
    for (int I = 0; I < size; ++I)
      for (int q = 0; q < 4; ++q) component(m_solution, I, q) = below(m_levels.size(), I)[q];
    const Solver_status status = m_coarsest.solve(m_solution, m_solution);
    for (int I = 0; I < size; ++I)
      for (int q = 0; q < 4; ++q) below(m_levels.size(), I)[q] = component(m_solution, I, q);
    return status;
  }

  std::vector<Level> m_levels;
  Coarsest m_coarsest;
  Block<Entry> m_solution;        // on the coarsest level
  Aligned_array<float> m_coarse;  // the same, with four numbers per vertex
};

}  // namespace Conformal_geometry_processing

#endif
