// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief solves linear systems with sparse Hermitian positive definite matrices of real numbers
/// or quaternions, on one pattern, with many values and many right-hand sides.
///
/// How the matrix is represented inside is the business of the model; only the ordering of the n
/// rows is visible, so that the solvers for different scalars on one mesh can share it. Failure is
/// a status and never an exception; a call that does not fit the earlier ones returns
/// `Solver_status::wrong_state`. After a failure, the last step that succeeded before the failing
/// one can be built upon. Models are default constructible; they need be neither copied nor moved.
/// One object is used by one thread at a time.
///
/// Products of quaternions do not commute: A x multiplies the scalars of x from the left. A model
/// whose solutions are less exact than those of a factorization says so. For templates over both
/// scalars, `Conformal_geometry_processing::conjugate()` of `algebra/Quaternion.h` is the identity
/// on numbers, and `Hermitian_sparse_matrix::diagonal()` a number.
///
/// Where only a preconditioner is wanted, as by the eigensolvers, a model may save time and memory
/// by two more members, `factorize_preconditioner(A, shift)` and `precondition(b, x)`, with the
/// parameters of `factorize()` and `solve()`: the solution is less exact, always the same for the
/// same b, and Hermitian positive definite as a function of b. A model with a member `release()`
/// gives back the memory of its factor when that is called; its analysis stays.
///
/// `examples/Ldl_solver.h` is a model of 200 lines, with nothing of the library but the headers
/// below. The test `test/quaternionic_linear_algebra/solver_laws.h` asks of a model all that this
/// page says.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Block`,
///   `Quaternionic_linear_algebra/algebra/Quaternion_vector.h`
/// - `Conformal_geometry_processing::Hermitian_sparse_matrix`,
///   `Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h`
/// - `Conformal_geometry_processing::Quaternion`,
///   `Quaternionic_linear_algebra/algebra/Quaternion.h`
/// - `Conformal_geometry_processing::Solver_statistics`,
///   `Quaternionic_linear_algebra/dense/Solver_status.h`
/// - `Conformal_geometry_processing::Solver_status`,
///   `Quaternionic_linear_algebra/dense/Solver_status.h`
/// - `Conformal_geometry_processing::Sparse_pattern`,
///   `Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h`
/// - `Conformal_geometry_processing::Vector`,
///   `Quaternionic_linear_algebra/algebra/Quaternion_vector.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Supernodal_cholesky`,}
/// \cgalHasModels{`Conformal_geometry_processing::Embedded_hermitian_solver`,}
/// \cgalHasModels{solvers of `Conformal_geometry_processing::Petsc_hermitian_solver_traits`.}
/// \cgalHasModelsEnd
class SparseHermitianSolver {
 public:
  /// \name Types
  /// @{

  /// `double` or `Quaternion<double>`
  typedef unspecified_type Scalar;

  /// the numbers below the scalars: `double`
  typedef unspecified_type FT;

  /// @}

  /// \name Operations
  /// @{

  /// \brief prepares for matrices on a pattern, and chooses an ordering.
  ///
  /// Done once per connectivity. The pattern need not outlive the call. One without rows is
  /// `Solver_status::wrong_state`.
  Solver_status analyze(const Sparse_pattern& pattern);

  /// \brief the same with a given ordering.
  ///
  /// \param order a permutation of the rows, as another solver's `ordering()` gives it: row
  /// `order[k]` is the k-th that is eliminated. What is none is `Solver_status::wrong_state`.
  Solver_status analyze(const Sparse_pattern& pattern, const std::vector<int>& order);

  /// the same, with a hint: column i of `positions`, 3 x n, is where vertex i is in space. A model
  /// that can make nothing of it ignores it.
  Solver_status analyze_with_positions(const Sparse_pattern& pattern,
                                       const Eigen::Matrix3Xd& positions);

  /// the same, with all that can be shared of the analysis of another solver of the same traits,
  /// maybe for another scalar, that has analyzed the same pattern
  template <class OtherSolver>
  Solver_status analyze_like(const Sparse_pattern& pattern, const OtherSolver& other);

  /// the ordering in use, numbered likewise; of no rows before `analyze()`
  const std::vector<int>& ordering() const;

  /// \brief factorizes A + diag(shift).
  ///
  /// Done any number of times, for matrices on the analyzed pattern; one of another size, or with
  /// another number of entries, is `Solver_status::wrong_state`.
  /// \param shift one number per row, which may be zero, or empty
  /// \returns `Solver_status::not_positive_definite` where a pivot is zero or negative,
  /// `Solver_status::numerical_issue` where a value is not finite
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift);

  /// \brief solves for several right-hand sides, the columns of b; without any it succeeds.
  ///
  /// \param x is resized; stays as it is unless the status is `Solver_status::success`
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// the cost of the factorization: scalars stored, floating-point operations (at least one for
  /// each of them), bytes; zeros before `analyze()`
  Solver_statistics statistics() const;

  /// @}
};
