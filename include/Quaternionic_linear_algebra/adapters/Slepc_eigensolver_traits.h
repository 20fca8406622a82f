// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/adapters/Petsc_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/adapters/Petsc_matrix.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

using Slepc_eps = Petsc_handle<EPS, EPSDestroy>;

// Returns whether the argument is true on all processes.
inline bool all_processes(bool yes)
{
  int answer = yes ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &answer, 1, MPI_INT, MPI_MIN, PETSC_COMM_WORLD);
  return answer == 1;
}

// Returns `wanted` columns that span, over the quaternions, as much of the span of V as possible:
// one of each pair of complex eigenvectors, which differ by a quaternion on the right.
inline Block<Quaternion<double>> quaternionic_basis(Block<Quaternion<double>> V,
                                                    Eigen::Index wanted)
{
  for (Eigen::Index j = 0; j < wanted; ++j) {
    Eigen::Index longest = j;
    const auto length = [&](Eigen::Index c) { return inner_product(V.col(c), V.col(c)).w; };
    for (Eigen::Index c = j + 1; c < V.cols(); ++c)
      if (length(c) > length(longest)) longest = c;
    if (longest != j) V.col(j).swap(V.col(longest));
    scale_column(V, j, 1 / std::sqrt(length(j)));
    for (Eigen::Index c = j + 1; c < V.cols(); ++c)
      add_multiple(V.col(c), V.col(j), -inner_product(V.col(j), V.col(c)));
  }
  return V.leftCols(wanted);
}

// Solves K x = x theta by the LOBPCG of SLEPc, for a quaternionic K in complex form, where each
// eigenvalue has even multiplicity: 2 k complex vectors correspond to k quaternionic ones. Nothing
// of the size of K is on every process.
//
// SLEPc tests the vectors of the block in sequence and returns those before the first that fails.
// Guard vectors, which need not converge, pass the test so that all vectors are returned together;
// all pass when the iteration ends without convergence.
template <class GoFurther>
class Slepc_lobpcg {
 public:
  // K has two rows for each quaternion
  Slepc_lobpcg(Mat K, PC preconditioner, const Eigensolver_options& options, GoFurther& go_further)
      : m_options(options), m_go_further(go_further)
  {
    check_petsc(EPSCreate(PETSC_COMM_WORLD, m_eps.renew()));
    check_petsc(EPSSetOptionsPrefix(m_eps.get(), "conformal_"));
    check_petsc(EPSSetOperators(m_eps.get(), K, nullptr));
    check_petsc(EPSSetProblemType(m_eps.get(), EPS_HEP));
    check_petsc(EPSSetWhichEigenpairs(m_eps.get(), EPS_SMALLEST_REAL));
    check_petsc(EPSSetType(m_eps.get(), EPSLOBPCG));
    check_petsc(EPSLOBPCGSetLocking(m_eps.get(), PETSC_FALSE));
    check_petsc(EPSLOBPCGSetRestart(m_eps.get(), 1));
    check_petsc(EPSSetConvergenceTestFunction(m_eps.get(), measure, this, nullptr));
    check_petsc(EPSSetStoppingTestFunction(m_eps.get(), stop, this, nullptr));
    set_preconditioner(preconditioner);
  }
  Slepc_lobpcg(const Slepc_lobpcg&) = delete;
  Slepc_lobpcg& operator=(const Slepc_lobpcg&) = delete;

  // SLEPc requires a problem several times as large as the block.
  static bool is_possible(const Block<Quaternion<double>>& x) { return x.rows() >= 5 * x.cols(); }

  // Starts from x and x j for some quaternionic vectors x, whose complex span is the quaternionic
  // span of x.
  void run(std::vector<Petsc_vec> initial)
  {
    const auto columns = static_cast<PetscInt>(initial.size());
    m_wanted = 2 * m_options.wanted;
    check_petsc(EPSLOBPCGSetBlockSize(m_eps.get(), columns));
    check_petsc(EPSSetDimensions(m_eps.get(), columns, PETSC_DEFAULT, PETSC_DEFAULT));
    check_petsc(EPSSetTolerances(m_eps.get(), m_options.tolerance, m_options.max_iterations + 2));
    std::vector<Vec> vectors;
    for (const Petsc_vec& v : initial) vectors.push_back(v.get());
    check_petsc(EPSSetInitialSpace(m_eps.get(), columns, vectors.data()));
    check_petsc(EPSSolve(m_eps.get()));
    if (m_exception) std::rethrow_exception(m_exception);
  }

  // number c of the complex eigenvectors
  void vector(int c, Vec v) const
  {
    check_petsc(EPSGetEigenvector(m_eps.get(), static_cast<PetscInt>(c), v, nullptr));
  }

  double value() const { return m_value; }
  double estimate() const { return m_estimate; }

  int iterations() const { return m_iterations; }
  bool is_cancelled() const { return m_is_cancelled; }

 private:
  // Wraps the preconditioner in a shell, because SLEPc destroys the one it is given.
  void set_preconditioner(PC preconditioner)
  {
    ST st = nullptr;
    KSP ksp = nullptr;
    PC shell = nullptr;
    check_petsc(EPSGetST(m_eps.get(), &st));
    check_petsc(STSetType(st, STPRECOND));
    check_petsc(STGetKSP(st, &ksp));
    check_petsc(KSPSetType(ksp, KSPPREONLY));
    check_petsc(KSPGetPC(ksp, &shell));
    check_petsc(PCSetType(shell, PCSHELL));
    check_petsc(PCShellSetContext(shell, preconditioner));
    check_petsc(PCShellSetApply(shell, apply_inner));
  }

  static PetscErrorCode apply_inner(PC shell, Vec b, Vec x)
  {
    PC inner = nullptr;
    const PetscErrorCode code = PCShellGetContext(shell, &inner);
    return code != 0 ? code : PCApply(inner, b, x);
  }

  // Called for each vector of the block in sequence.
  static PetscErrorCode measure(EPS, PetscScalar value, PetscScalar, PetscReal residual,
                                PetscReal* error, void* self_)
  {
    Slepc_lobpcg& self = *static_cast<Slepc_lobpcg*>(self_);
    const bool is_wanted = self.m_measured < self.m_wanted;
    if (self.m_measured == 0) {
      self.m_value = value.real();
      self.m_estimate = 0;
    }
    if (is_wanted) self.m_estimate = (std::max)(self.m_estimate, residual);
    ++self.m_measured;
    *error = is_wanted && !self.m_is_last ? residual : 0;
    return 0;
  }

  // Called after `measure()` for the whole block.
  static PetscErrorCode stop(EPS, PetscInt iterations, PetscInt, PetscInt converged, PetscInt block,
                             EPSConvergedReason* reason, void* self_)
  {
    Slepc_lobpcg& self = *static_cast<Slepc_lobpcg*>(self_);
    self.m_measured = 0;
    self.m_iterations = static_cast<int>(iterations);
    if (converged >= block)
      *reason = EPS_CONVERGED_USER;
    else
      self.m_is_last = iterations + 1 >= self.m_options.max_iterations || !self.goes_further();
    return 0;
  }

  bool goes_further()
  {
    bool yes = false;
    try {
      yes = m_go_further(Eigensolver_progress{m_iterations, m_value, m_estimate});
    } catch (...) {  // exceptions must not propagate through SLEPc
      m_exception = std::current_exception();
    }
    m_is_cancelled = !all_processes(yes);
    return !m_is_cancelled;
  }

  const Eigensolver_options m_options;
  GoFurther& m_go_further;
  Slepc_eps m_eps;
  int m_wanted = 0, m_measured = 0, m_iterations = 0;
  double m_value = 0, m_estimate = 0;
  bool m_is_last = false, m_is_cancelled = false;
  std::exception_ptr m_exception;
};

// Transforms A x = N x theta to K y = y theta / scale^2, with numbers of order one.
class Mass_scaling {
 public:
  Mass_scaling(const Vector<double>& masses, double scale)
      : m_roots(masses.cwiseSqrt()), m_scale(scale)
  {}

  double to_scaled(double value) const { return value / (m_scale * m_scale); }
  double from_scaled(double value) const { return value * (m_scale * m_scale); }

  Hermitian_sparse_matrix<Quaternion<double>> to_scaled(
      const Hermitian_sparse_matrix<Quaternion<double>>& A) const
  {
    auto K = A;
    int k = 0;
    A.for_each_entry([&](int i, int j, const Quaternion<double>& a) {
      K.value(k++) = a / (m_roots[i] * m_roots[j] * m_scale * m_scale);
    });
    return K;
  }

  void to_scaled(Block<Quaternion<double>>& x) const { scale_rows(x, m_roots); }
  void from_scaled(Block<Quaternion<double>>& x) const { scale_rows(x, m_roots.cwiseInverse()); }

 private:
  static void scale_rows(Block<Quaternion<double>>& x, const Vector<double>& factors)
  {
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (Eigen::Index i = 0; i < x.rows(); ++i) x(i, c) *= factors[i];
  }

  Vector<double> m_roots;
  double m_scale;
};

// Upper bound of the spectral norm: the maximal row sum of norms.
inline double norm_bound(const Hermitian_sparse_matrix<Quaternion<double>>& K)
{
  Vector<double> sums = Vector<double>::Zero(K.size());
  K.for_each_entry([&](int i, int j, const Quaternion<double>& a) {
    sums[i] += norm(a);
    if (i != j) sums[j] += norm(a);
  });
  return sums.size() > 0 ? sums.maxCoeff() : 0;
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the smallest eigenpairs by the LOBPCG of SLEPc with algebraic multigrid, divided
/// among processes; what calls it, with the mesh, the matrix and all results, is replicated on each
/// of them. Link the component `slepc`.
///
/// The program calls `SlepcInitialize()` before and `SlepcFinalize()` after (they initialize MPI).
/// All processes of `PETSC_COMM_WORLD` call with the same arguments and get the same result.
/// SLEPc's copy of the matrix, the multigrid hierarchy and the work vectors, which are many times
/// larger than what is replicated, are distributed by rows.
/// All processes must round in the same way, as those of one program on identical machines do.
///
/// The given solver is not used; for algorithms that need one use `Petsc_hermitian_solver_traits`.
/// SLEPc computes pairs of complex vectors, which are converted to quaternions and verified by
/// `lobpcg()` with the same multigrid; if necessary, `lobpcg()` improves them. The error estimates
/// are therefore those of the default eigensolver, with one multigrid cycle in place of the
/// inverse. PETSc options have the prefixes `-conformal_` and `-conformal_grids_`.
///
/// \cgalModels{SparseHermitianEigensolverTraits}
struct Slepc_eigensolver_traits {
  /// \param N the masses
  /// \param go_further is called on all processes; the iteration is cancelled if it returns false
  /// on one of them \throws Precondition_error if there are fewer columns in x0 than wanted \throws
  /// Solver_error if PETSc is not initialized, or fails
  template <class Solver, class GoFurther = internal::Always_go_further>
  Eigensolver_result operator()(const Hermitian_sparse_matrix<Quaternion<double>>& A,
                                const Vector<double>& N, const Solver&,
                                Block<Quaternion<double>> x0,
                                const Eigensolver_options& options = {},
                                GoFurther go_further = {}) const
  {
    if (!internal::petsc_is_running())
      throw Solver_error(function, "PETSc is not running; SlepcInitialize() has to be called");
    const internal::Eigensolver_convergence checks_arguments(function, options, x0);
    const internal::Quiet_petsc quiet;
    const internal::Mass_scaling scaling(N, options.scale);
    const auto ask = [&](Eigensolver_progress progress) {
      progress.value = scaling.from_scaled(progress.value);
      return go_further(progress);
    };
    scaling.to_scaled(x0);
    Eigensolver_result result = solve(scaling.to_scaled(A), std::move(x0), options, ask);
    scaling.from_scaled(result.vectors);
    for (double& value : result.values) value = scaling.from_scaled(value);
    if (result.gap) result.gap = scaling.from_scaled(*result.gap);
    return result;
  }

 private:
  static constexpr const char* function = "Slepc_eigensolver_traits";

  /// Solves K x = x theta, with eigenvalues of order one
  template <class GoFurther>
  static Eigensolver_result solve(const Hermitian_sparse_matrix<Quaternion<double>>& K,
                                  Block<Quaternion<double>> x, Eigensolver_options options,
                                  GoFurther go_further)
  {
    const Vector<double> ones = Vector<double>::Ones(K.size());
    internal::Petsc_hermitian_solver<Quaternion<double>> grids;
    check(grids.analyze(K.pattern()));
    check(grids.factorize(K, 1e-3 * ones));  // K may be singular
    options.scale = 1;
    options.adapt = {};  // it would change A and not K
    int iterations = 0;
    bool is_cancelled = false;
    if (internal::Slepc_lobpcg<GoFurther>::is_possible(x) && options.max_iterations > 0) {
      internal::Petsc_matrix<Quaternion<double>> distributed(K.pattern(), grids.ordering());
      distributed.set_values(K, {});
      internal::Slepc_lobpcg<GoFurther> slepc(distributed.get(), grids.multigrid(),
                                              above_rounding(options, K), go_further);
      slepc.run(initial(x, distributed));
      x = vectors(slepc, x.cols(), distributed);
      iterations = slepc.iterations();
      is_cancelled = slepc.is_cancelled();
    }
    options.max_iterations = is_cancelled ? 0 : (std::max)(0, options.max_iterations - iterations);
    const auto agreed = [&](const Eigensolver_progress& p) {
      return internal::all_processes(go_further(p));
    };
    Eigensolver_result result =
        Lobpcg_eigensolver_traits()(K, ones, grids, std::move(x), options, agreed);
    result.iterations += iterations;
    result.solves += iterations;
    result.cancelled = result.cancelled || (is_cancelled && !result.converged);
    return result;
  }

  static std::vector<internal::Petsc_vec> initial(
      Block<Quaternion<double>> x, const internal::Petsc_matrix<Quaternion<double>>& K)
  {
    const Quaternion<double> j{0, 0, 1, 0};
    std::vector<internal::Petsc_vec> all;
    for (Eigen::Index c = 0; c < 2 * x.cols(); ++c) {
      if (c % 2 == 1)
        for (Eigen::Index i = 0; i < x.rows(); ++i) x(i, c / 2) = x(i, c / 2) * j;
      all.push_back(K.make_vector());
      K.to_petsc(x, c / 2, all.back().get());
    }
    return all;
  }

  template <class Lobpcg>
  static Block<Quaternion<double>> vectors(const Lobpcg& slepc, Eigen::Index columns,
                                           const internal::Petsc_matrix<Quaternion<double>>& K)
  {
    Block<Quaternion<double>> all(K.size(), 2 * columns);
    const internal::Petsc_vec v = K.make_vector();
    for (Eigen::Index c = 0; c < all.cols(); ++c) {
      slepc.vector(static_cast<int>(c), v.get());
      K.from_petsc(v.get(), c, all);
    }
    return internal::quaternionic_basis(std::move(all), columns);
  }

  /// Keeps the tolerance of SLEPc above the rounding errors of products with K
  static Eigensolver_options above_rounding(Eigensolver_options options,
                                            const Hermitian_sparse_matrix<Quaternion<double>>& K)
  {
    const double rounding = std::numeric_limits<double>::epsilon() * internal::norm_bound(K);
    options.tolerance = (std::max)(options.tolerance, 100 * rounding);
    return options;
  }

  static void check(Solver_status status)
  {
    if (status != Solver_status::success)
      throw Solver_error(function,
                         std::string("setup of the multigrid failed: ") + to_string(status));
  }
};

}  // namespace Conformal_geometry_processing
