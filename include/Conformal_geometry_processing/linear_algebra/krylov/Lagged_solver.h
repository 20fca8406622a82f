// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LAGGED_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LAGGED_SOLVER_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/dense/guarded.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Scalar_planes.h>
#include <Conformal_geometry_processing/linear_algebra/direct/release_factor.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Refactorization_rule.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief solves systems with a matrix that changes little from one `factorize()` to the next, as
/// in the steps of a flow: keeps the old factor for as long as that pays.
///
/// The first `factorize()` factors; later ones may just take the values. Then `solve()` runs
/// conjugate gradients on the *present* matrix, preconditioned by the old factor, up to an
/// estimated error of `tolerance()` in the energy norm. When to factor anew is decided by counted
/// solves
/// (`Refactorization_rule`), `solve()` and `precondition()` included, so that no step costs more
/// than twice what it would with a new factor; the results are the same bits every time.
///
/// The Laplacian of a surface does not change under conformal maps, so one factor serves a whole
/// flow with two iterations per system.
///
/// An indefinite matrix is always found out by a factorization, but not always in `factorize()`:
/// `solve()` and `precondition()` may return `Solver_status::not_positive_definite` as well.
/// Keeps a copy of the values of the matrix.
///
/// \tparam Solver_ a model of `SparseHermitianSolver`, which does the factorizations
/// \cgalModels{SparseHermitianSolver}
template <class Solver_>
class Lagged_solver {
 public:
  using Scalar = typename Solver_::Scalar;
  using FT = typename Solver_::FT;

  Lagged_solver() = default;
  Lagged_solver(const Lagged_solver&) = delete;
  Lagged_solver& operator=(const Lagged_solver&) = delete;

  Solver_status analyze(const Sparse_pattern& pattern)
  {
    return adopt(pattern, m_solver.analyze(pattern));
  }
  Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order)
  {
    return adopt(pattern, m_solver.analyze(pattern, order));
  }
  Solver_status analyze_with_positions(const Sparse_pattern& pattern,
                                       const Eigen::Matrix3Xd& positions)
  {
    return adopt(pattern, m_solver.analyze_with_positions(pattern, positions));
  }
  template <class OtherSolver>
  Solver_status analyze_like(const Sparse_pattern& pattern, const OtherSolver& other)
  {
    return adopt(pattern, m_solver.analyze_like(pattern, other));
  }
  template <class OtherSolver>
  Solver_status analyze_like(const Sparse_pattern& pattern, const Lagged_solver<OtherSolver>& other)
  {
    return adopt(pattern, m_solver.analyze_like(pattern, other.factor()));
  }

  const Ordering& ordering() const { return m_solver.ordering(); }

  /// takes the values; factors them where that is cheaper than to go on with the old factor
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    return internal::guarded([&] {
      const int n = static_cast<int>(ordering().size());
      if (n == 0 || A.size() != n || A.pattern().size_of_entries() != m_entries ||
          (shift.size() != 0 && shift.size() != n))
        return Solver_status::wrong_state;
      m_is_ready = m_is_current = false;
      m_A = A;
      m_shift = shift;
      if (!add_shift()) return Solver_status::numerical_issue;
      const bool is_worn = m_rule.begin_step();
      if (is_worn || !m_has_factor || !has_positive_diagonal()) return renew();
      m_is_ready = true;
      return Solver_status::success;
    });
  }

  /// the exact solution where the factor is that of the present matrix, else one to `tolerance()`
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return internal::guarded([&] {
      if (!m_is_ready || b.rows() != m_A.size()) return Solver_status::wrong_state;
      m_iterations = 0;
      if (!m_is_current) {
        if (iterate(b, x)) return Solver_status::success;
        const Solver_status status = renew_in_the_midst();
        if (status != Solver_status::success) return status;
      }
      return m_solver.solve(b, x);
    });
  }

  /// \brief one application of the factor at hand, old or new.
  ///
  /// Its matrix may be replaced by the present one between two calls.
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return internal::guarded([&] {
      if (!m_is_ready || b.rows() != m_A.size()) return Solver_status::wrong_state;
      if (!m_is_current && m_rule.budget() <= 0) {
        const Solver_status status = renew_preconditioner();
        if (status != Solver_status::success) return status;
      }
      m_rule.add(work_per_preconditioned_pass * passes(b));
      return apply_inverse(m_solver, b, x);
    });
  }

  /// gives back the memory of the factor, if `Solver_` can; the next `factorize()` makes a new one
  void release()
  {
    release_factor(m_solver);
    m_has_factor = m_is_ready = m_is_current = false;
  }

  /// the cost of a factorization; the memory includes that of the values
  Solver_statistics statistics() const
  {
    Solver_statistics s = m_solver.statistics();
    if (s.factor_entries > 0) s.bytes += static_cast<double>(sizeof(Scalar)) * m_entries;
    return s;
  }

  /// the estimated relative error of `solve()` in the energy norm, 1e-9 if not set
  FT tolerance() const { return m_tolerance; }
  void set_tolerance(FT tolerance) { m_tolerance = tolerance; }

  /// the solver that holds the factor, which may be older than the matrix
  const Solver_& factor() const { return m_solver; }

  /// whether the factor is that of the present matrix
  bool is_current() const { return m_is_current; }

  /// how often a factorization has been tried since `analyze()`
  int factorizations() const { return m_factorizations; }

  /// how many iterations of conjugate gradients the last `solve()` took, 0 if it was direct
  int iterations() const { return m_iterations; }

 private:
  static constexpr int planes = Scalar_planes<Scalar>::size;

  // A pass through the factor solves for four numbers per row at once. With products, sums and
  // inner products an iteration takes about a fifth more than its pass.
  static constexpr double work_per_pass = 1.2;

  // An iteration of an eigenvalue solver, which calls `precondition()`, takes twice its pass: more
  // products, and Gram matrices of three vectors.
  static constexpr double work_per_preconditioned_pass = 2;

  static double passes(const Block<Scalar>& b)
  {
    return std::ceil(static_cast<double>(b.cols()) * planes / 4);
  }

  Solver_status adopt(const Sparse_pattern& pattern, Solver_status status)
  {
    m_entries = pattern.size_of_entries();
    m_has_factor = m_is_ready = m_is_current = false;
    m_factorizations = m_iterations = 0;
    m_rule = {};
    return status;
  }

  // Returns false where a value is not finite.
  bool add_shift()
  {
    bool is_finite = true;
    for (Eigen::Index j = 0; j < m_shift.size(); ++j)
      m_A.value(diagonal_position(j)) += Scalar_traits<Scalar>::from_real(m_shift[j]);
    for (int k = 0; k < m_entries; ++k) {
      FT c[planes];
      Scalar_planes<Scalar>::get(m_A.value(k), c);
      for (const FT number : c) is_finite = is_finite && std::isfinite(number);
    }
    return is_finite;
  }

  int diagonal_position(Eigen::Index j) const
  {
    return m_A.pattern().offsets[static_cast<std::size_t>(j)];
  }

  // Where it has not, no iteration is needed to see that the matrix is not definite.
  bool has_positive_diagonal() const
  {
    for (int j = 0; j < m_A.size(); ++j)
      if (!(m_A.diagonal(j) > 0)) return false;
    return true;
  }

  Solver_status renew(const Vector<FT>& more = {}) const
  {
    m_has_factor = m_is_ready = m_is_current = false;
    ++m_factorizations;
    const Solver_status status = m_solver.factorize(m_A, more);
    if (status != Solver_status::success) return status;
    m_has_factor = m_is_ready = true;
    m_is_current = more.size() == 0;
    m_rule.set_price(factorization_price(m_solver.statistics(), planes));
    m_rule.renewed();
    return status;
  }

  Solver_status renew_in_the_midst() const
  {
    const Solver_status status = renew();
    m_rule.renewed_in_the_midst();
    return status;
  }

  // A shift guards against rounding, and may turn out too small for that. Whoever set it would have
  // heard of it in factorize(), and taken a larger one; to a preconditioner that is open now, too.
  Solver_status renew_preconditioner() const
  {
    const Solver_status status = renew_in_the_midst();
    if (status != Solver_status::not_positive_definite || m_shift.size() == 0) return status;
    return renew(9 * m_shift);
  }

  // Conjugate gradients, for as long as they are cheaper than a factorization and a direct solve.
  bool iterate(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    const double direct = passes(b), work = work_per_pass * direct;
    const auto precondition = [&](const Block<Scalar>& r, Block<Scalar>& z) {
      if (apply_inverse(m_solver, r, z) != Solver_status::success)
        z = r * std::numeric_limits<FT>::quiet_NaN();
    };
    Conjugate_gradients_options options;
    options.tolerance = static_cast<double>(m_tolerance);
    options.max_iterations = work == 0 ? 0 : static_cast<int>((m_rule.budget() + direct) / work);
    Block<Scalar> solution;
    const auto result =
        conjugate_gradients(block_operator(m_A), precondition, b, solution, options);
    m_iterations = result.iterations;
    m_rule.add(work * result.iterations - direct);
    if (result.converged) x = std::move(solution);
    return result.converged;
  }

  int m_entries = 0;
  Hermitian_sparse_matrix<Scalar> m_A;  // the present matrix, shift included
  Vector<FT> m_shift;
  FT m_tolerance = FT(1e-9);
  // A solve may find that the factor has to be replaced.
  mutable Solver_ m_solver;
  mutable Refactorization_rule m_rule;
  mutable bool m_has_factor = false, m_is_ready = false, m_is_current = false;
  mutable int m_factorizations = 0, m_iterations = 0;
};

/// \ingroup PkgLinearAlgebra
/// \brief lagged solvers for all scalars, for flows.
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \cgalModels{SparseHermitianSolverTraits}
template <class SolverTraits = Default_solver_traits>
struct Lagged_solver_traits {
  template <class Scalar>
  using Solver = Lagged_solver<typename SolverTraits::template Solver<Scalar>>;
};

}  // namespace Conformal_geometry_processing

#endif
