// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief finds the smallest eigenpairs of A x = N x theta over the quaternions, given a
/// factorization of A plus a small shift: what `Dirac_options::eigensolver` takes.
///
/// Eigenvectors are right ones and defined up to a quaternion on their right; each eigenvalue
/// counts once. If the iteration does not converge, the result says so; this is not an error.
///
/// An eigenvalue with several eigenvectors is returned as often as the block has room for it. The
/// library asks for one vector, takes it only if it lies on the branch that it follows, and looks
/// for the next eigenvalue by itself. Who asks for several has to know: Krylov methods that begin
/// with one vector miss copies at loose tolerances, and count as converged; blocks do not.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Block`,
///   `Quaternionic_linear_algebra/algebra/Quaternion_vector.h`
/// - `Conformal_geometry_processing::Dirac_options`,
///   `Conformal_geometry_processing/spin/Dirac_solution.h`
/// - `Conformal_geometry_processing::Eigensolver_options`,
///   `Quaternionic_linear_algebra/krylov/Eigensolver_result.h`
/// - `Conformal_geometry_processing::Eigensolver_progress`,
///   `Quaternionic_linear_algebra/krylov/Eigensolver_result.h`
/// - `Conformal_geometry_processing::Eigensolver_result`,
///   `Quaternionic_linear_algebra/krylov/Eigensolver_result.h`
/// - `Conformal_geometry_processing::Hermitian_sparse_matrix`,
///   `Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h`
/// - `Conformal_geometry_processing::Quaternion`,
///   `Quaternionic_linear_algebra/algebra/Quaternion.h`
/// - `Conformal_geometry_processing::Vector`,
///   `Quaternionic_linear_algebra/algebra/Quaternion_vector.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Lobpcg_eigensolver_traits`, the default;}
/// \cgalHasModels{`Conformal_geometry_processing::Inverse_power_eigensolver_traits`}
/// \cgalHasModels{`Conformal_geometry_processing::Slepc_eigensolver_traits`}
/// \cgalHasModelsEnd
class SparseHermitianEigensolverTraits {
 public:
  /// \brief runs the iteration.
  ///
  /// \tparam Masses `Vector<double>`, the diagonal of N; a model may also take a
  /// `Hermitian_sparse_matrix<Quaternion<double>>`
  /// \tparam Solver a model of `SparseHermitianSolver` for quaternions
  /// \tparam GoFurther a callable `bool(const Eigensolver_progress&)`
  /// \param A Hermitian, positive semidefinite
  /// \param N positive definite
  /// \param solver has factorized A plus a small positive definite shift, which does not move the
  /// result. To be applied by `apply_inverse()` or `inverse_operator()`: a solver with a member
  /// `factorize_preconditioner()` has used that, and the inverse is not exact
  /// \param x0 the initial vectors, one or more
  /// \param options when to stop, and how many eigenpairs are wanted: at most the columns of x0
  /// \param go_further is asked before every iteration; false cancels
  template <class Masses, class Solver, class GoFurther = unspecified_type>
  Eigensolver_result operator()(const Hermitian_sparse_matrix<Quaternion<double>>& A,
                                const Masses& N, const Solver& solver, Block<Quaternion<double>> x0,
                                const Eigensolver_options& options = {},
                                GoFurther go_further = {}) const;
};
