// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LAGGED_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LAGGED_SOLVER_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/algebra/scalar.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Refactorization_rule.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Solves systems with a matrix that changes little from one `factorize()` to the next, as
/// in the steps of a flow: reuses the old factor as long as that is cheaper.
///
/// The first `factorize()` factors the matrix; later ones may only store its values. Then `solve()`
/// runs conjugate gradients on the *current* matrix, preconditioned by the old factor, up to an
/// estimated error of `tolerance()` in the energy norm. `Refactorization_rule` decides when to
/// refactor by counting solves, those of `solve()` and `precondition()`, such that no step costs
/// more than twice as much as with a new factor. Results are bitwise reproducible.
///
/// The Laplacian of a surface does not change under conformal maps, so one factor serves a whole
/// flow with two iterations per system.
///
/// An indefinite matrix is always detected by a factorization, but not always in `factorize()`:
/// `solve()` and `precondition()` may return `Solver_status::not_positive_definite` as well.
/// Stores a copy of the values of the matrix.
///
/// \tparam Solver_ a model of `SparseHermitianSolver`, which computes the factorizations
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

  /// Stores the values; factors them if that is cheaper than to reuse the old factor
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift);

  /// Solves directly if the factor is current, otherwise iteratively up to `tolerance()`
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// \brief Applies the factor once, whether it is current or not.
  ///
  /// The factor may be renewed between two calls.
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// Releases the memory of the factor, if `Solver_` supports it; the next `factorize()` refactors
  void release();

  /// Cost of a factorization; the memory includes the values of the matrix
  Solver_statistics statistics() const;

  /// Estimated relative error of `solve()` in the energy norm, 1e-9 by default
  FT tolerance() const { return m_tolerance; }
  void set_tolerance(FT tolerance) { m_tolerance = tolerance; }

  /// The solver that holds the factor, which may be older than the matrix
  const Solver_& factor() const { return m_solver; }

  /// Returns whether the factor is that of the current matrix
  bool is_current() const { return m_is_current; }

  /// Number of factorizations, including failed ones, since `analyze()`
  int factorizations() const { return m_factorizations; }

  /// Number of conjugate gradient iterations of the last `solve()`, 0 if it was direct
  int iterations() const { return m_iterations; }

 private:
  static constexpr int planes = Scalar_planes<Scalar>::size;

  // A pass through the factor solves for four numbers per row at once. Including products, sums and
  // inner products, an iteration takes about 20 % longer than its pass.
  static constexpr double work_per_pass = 1.2;

  // An iteration of an eigensolver, which calls `precondition()`, takes twice its pass, because of
  // more products and Gram matrices of three vectors.
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
  Hermitian_sparse_matrix<Scalar> m_A;  // the current matrix, including the shift
  Vector<FT> m_shift;
  FT m_tolerance = FT(1e-9);
  // Mutable, because a solve may have to replace the factor.
  mutable Solver_ m_solver;
  mutable Refactorization_rule m_rule;
  mutable bool m_has_factor = false, m_is_ready = false, m_is_current = false;
  mutable int m_factorizations = 0, m_iterations = 0;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Lagged solvers for all scalars, for flows.
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \cgalModels{SparseHermitianSolverTraits}
template <class SolverTraits = Default_solver_traits>
struct Lagged_solver_traits {
  template <class Scalar>
  using Solver = internal::Lagged_solver<typename SolverTraits::template Solver<Scalar>>;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/krylov/Lagged_solver_templates.h>
#endif

#endif
