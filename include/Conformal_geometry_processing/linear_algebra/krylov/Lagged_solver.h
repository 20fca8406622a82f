// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LAGGED_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LAGGED_SOLVER_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Scalar_planes.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Refactorization_rule.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>

#include <Eigen/Core>

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

  Solver_status analyze(const Sparse_pattern& pattern);
  Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order);
  Solver_status analyze_with_positions(const Sparse_pattern& pattern,
                                       const Eigen::Matrix3Xd& positions);
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
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift);

  /// the exact solution where the factor is that of the present matrix, else one to `tolerance()`
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// \brief one application of the factor at hand, old or new.
  ///
  /// Its matrix may be replaced by the present one between two calls.
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// gives back the memory of the factor, if `Solver_` can; the next `factorize()` makes a new one
  void release();

  /// the cost of a factorization; the memory includes that of the values
  Solver_statistics statistics() const;

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

  static double passes(const Block<Scalar>& b);
  Solver_status adopt(const Sparse_pattern& pattern, Solver_status status);
  bool add_shift();
  int diagonal_position(Eigen::Index j) const;
  bool has_positive_diagonal() const;

  Solver_status renew(const Vector<FT>& more = {}) const;

  Solver_status renew_in_the_midst() const;
  Solver_status renew_preconditioner() const;
  bool iterate(const Block<Scalar>& b, Block<Scalar>& x) const;

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

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/krylov/Lagged_solver_templates.h>
#endif

#endif
