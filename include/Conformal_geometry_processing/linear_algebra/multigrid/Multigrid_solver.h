// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_MULTIGRID_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_MULTIGRID_SOLVER_H

#include <Conformal_geometry_processing/linear_algebra/dense/guarded.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Scalar_planes.h>
#include <Conformal_geometry_processing/linear_algebra/direct/amd_ordering.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_cycle.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Rounding_remainder.h>

#include <Eigen/Core>

#include <cstddef>
#include <numeric>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief solves by smoothed aggregation multigrid: for meshes so large that the factor of a direct
/// solver takes too much time or memory.
///
/// One V-cycle, the preconditioner, costs two passes over the matrix in single precision, and a
/// sixth of that on the coarser levels. `solve()` runs conjugate gradients with it, in double
/// precision. The number of iterations depends on how thin the triangles are and not on how many
/// there are; 10 to 30 on smooth meshes, several times as many on hard scans.
///
/// Matrices of at most `direct_size` rows are factorized, and solved to rounding. For larger ones
/// positive definiteness is checked only as far as it is seen: on the diagonals of all levels, in
/// the factor of the coarsest one, and in the curvatures that conjugate gradients meets.
///
/// Of the matrix it keeps two halves in single precision (`Rounding_remainder`), and shares the
/// pattern. Memory: 240 bytes per vertex of a triangle mesh for quaternionic matrices, 110 for real
/// ones.
///
/// \tparam Scalar_ `double` or `Quaternion<double>`
/// \cgalModels{SparseHermitianSolver}
template <class Scalar_>
class Multigrid_solver {
 public:
  using Scalar = Scalar_;
  using FT = typename Scalar_traits<Scalar>::FT;

  /// so many rows are not worth a hierarchy
  static constexpr int direct_size = 500;

  /// of the error that `solve()` leaves, relative to the solution, in the energy norm
  static constexpr double tolerance = 1e-10;

  /// after which `solve()` gives up
  static constexpr int max_iterations = 500;

  explicit Multigrid_solver(const Multigrid_options& options = {}) : m_options(options) {}
  Multigrid_solver(const Multigrid_solver&) = delete;
  Multigrid_solver& operator=(const Multigrid_solver&) = delete;

  /// keeps the order of the rows, but for matrices that will be factorized directly
  Solver_status analyze(const Sparse_pattern& pattern)
  {
    return internal::guarded([&] {
      if (pattern.size() <= direct_size) return analyze(pattern, amd_ordering(pattern));
      Ordering identity(static_cast<std::size_t>(pattern.size()));
      std::iota(identity.begin(), identity.end(), 0);
      return analyze(pattern, identity);
    });
  }

  /// \param order is what `ordering()` tells then; large matrices stay in the order of their rows
  Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order)
  {
    return internal::guarded([&] {
      m_state = State::empty;
      m_cycle.release();
      if (pattern.size() == 0 || order.size() != static_cast<std::size_t>(pattern.size()) ||
          inverse_permutation(order).empty())
        return Solver_status::wrong_state;
      m_entries = pattern.size_of_entries();
      m_ordering = order;
      const Solver_status status =
          is_direct() ? m_direct.analyze(pattern, order) : Solver_status::success;
      if (status == Solver_status::success) m_state = State::analyzed;
      return status;
    });
  }

  /// positions are of no use
  Solver_status analyze_with_positions(const Sparse_pattern& pattern, const Eigen::Matrix3Xd&)
  {
    return analyze(pattern);
  }

  /// takes over the ordering
  template <class OtherSolver>
  Solver_status analyze_like(const Sparse_pattern& pattern, const OtherSolver& other)
  {
    return analyze(pattern, other.ordering());
  }

  const Ordering& ordering() const { return m_ordering; }

  /// builds the levels anew: aggregates follow the values
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    return internal::guarded([&] {
      if (m_state == State::empty || A.size() != size() ||
          A.pattern().size_of_entries() != m_entries ||
          (shift.size() != 0 && shift.size() != A.size()))
        return Solver_status::wrong_state;
      release();
      const Solver_status status = is_direct() ? m_direct.factorize(A, shift) : build(A, shift);
      if (status == Solver_status::success)
        m_state = State::factorized;
      else
        release();
      return status;
    });
  }

  /// gives the memory of the levels back; the analysis stays
  void release()
  {
    if (m_state == State::factorized) m_state = State::analyzed;
    m_direct.release();
    m_cycle.release();
    m_remainder.release();
  }

  /// \brief x = T b for every column, where T is one V-cycle: a fixed Hermitian positive definite
  /// operator close to the inverse of the factorized matrix.
  /// \param x may be b; is written in its memory, if it has the size
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return internal::guarded([&] {
      if (!is_ready(b)) return Solver_status::wrong_state;
      if (is_direct()) return m_direct.solve(b, x);
      x.resize(b.rows(), b.cols());
      Solver_status status = Solver_status::success;
      for (Eigen::Index c = 0; c < b.cols() && status == Solver_status::success; c += columns)
        status = m_cycle.apply([&](int i, double* to) { load(b, i, c, to); },
                               [&](int i, const double* from) { store(from, i, c, x); });
      return status;
    });
  }

  /// \returns `numerical_issue` where `max_iterations` do not lead to `tolerance` as well
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return internal::guarded([&] {
      if (!is_ready(b)) return Solver_status::wrong_state;
      return is_direct() ? m_direct.solve(b, x) : iterate(b, x);
    });
  }

  /// of the last `solve()` that succeeded; zero if it was direct
  int iterations() const { return m_iterations; }

  /// the levels; empty if the solver is direct
  const Multigrid_cycle<typename Rounding_remainder<Scalar>::Entry>& cycle() const
  {
    return m_cycle;
  }

  /// \brief the entries of all levels and of the factor of the coarsest one.
  ///
  /// As they depend on the values, only those of the matrix itself are known before `factorize()`.
  Solver_statistics statistics() const
  {
    if (m_state == State::empty) return {};
    if (is_direct()) return m_direct.statistics();
    if (m_state == State::analyzed) return {m_entries, 0, 0};
    Solver_statistics s = m_cycle.statistics();
    s.bytes += m_remainder.bytes();
    return s;
  }

 private:
  static constexpr int columns = 4 / Scalar_planes<Scalar>::size;
  enum class State { empty, analyzed, factorized };

  int size() const { return static_cast<int>(m_ordering.size()); }
  bool is_direct() const { return size() <= direct_size; }
  bool is_ready(const Block<Scalar>& b) const
  {
    return m_state == State::factorized && b.rows() == size();
  }

  Solver_status build(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    auto rounded = m_remainder.split(A, shift);
    if (!m_remainder.is_finite()) return Solver_status::numerical_issue;
    return m_cycle.build(std::move(rounded), m_options);
  }

  Solver_status iterate(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    Solver_status status = Solver_status::success;
    const auto multiply = [&](const Block<Scalar>& p) {
      Block<Scalar> y;
      m_remainder.multiply(m_cycle.levels().front().matrix(), p, y);
      return y;
    };
    const auto cycle = [&](const Block<Scalar>& r) {
      Block<Scalar> z = Block<Scalar>::Constant(r.rows(), r.cols(), Scalar{});
      if (status == Solver_status::success) status = precondition(r, z);
      return z;
    };
    Block<Scalar> solution;
    const auto result =
        conjugate_gradients(multiply, cycle, b, solution, {tolerance, max_iterations});
    if (status != Solver_status::success) return status;
    if (result.indefinite) return Solver_status::not_positive_definite;
    if (!result.converged) return Solver_status::numerical_issue;
    m_iterations = result.iterations;
    x = std::move(solution);
    return Solver_status::success;
  }

  // Vertex i of columns c, c + 1, ...: as many as fill four numbers, zero where there is none.
  static void load(const Block<Scalar>& b, int i, Eigen::Index c, double* to)
  {
    constexpr int planes = Scalar_planes<Scalar>::size;
    for (int k = 0; k < columns; ++k)
      Scalar_planes<Scalar>::get(c + k < b.cols() ? b(i, c + k) : Scalar{}, to + k * planes);
  }
  static void store(const double* from, int i, Eigen::Index c, Block<Scalar>& x)
  {
    constexpr int planes = Scalar_planes<Scalar>::size;
    for (int k = 0; k < columns && c + k < x.cols(); ++k)
      x(i, c + k) = Scalar_planes<Scalar>::put(from + k * planes);
  }

  Multigrid_options m_options;
  State m_state = State::empty;
  Ordering m_ordering;
  int m_entries = 0;
  Supernodal_cholesky<Scalar> m_direct;
  Rounding_remainder<Scalar> m_remainder;
  // Holds the vectors of the cycle, which nobody sees from outside.
  mutable Multigrid_cycle<typename Rounding_remainder<Scalar>::Entry> m_cycle;
  mutable int m_iterations = 0;
};

/// \ingroup PkgLinearAlgebra
/// \brief multigrid for real and quaternionic matrices; header-only.
/// \cgalModels{SparseHermitianSolverTraits}
struct Multigrid_solver_traits {
  template <class Scalar>
  using Solver = Multigrid_solver<Scalar>;
};

}  // namespace Conformal_geometry_processing

#endif
