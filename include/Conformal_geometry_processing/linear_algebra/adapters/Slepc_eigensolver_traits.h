// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/adapters/Petsc_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/adapters/Slepc_lobpcg.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

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
/// \brief Computes the smallest eigenpairs by the LOBPCG of SLEPc with algebraic multigrid, over
/// MPI: for meshes whose factors exceed the memory of one machine. Link the component `slepc`.
///
/// The program calls `SlepcInitialize()` before and `SlepcFinalize()` after (they initialize MPI).
/// All processes of `PETSC_COMM_WORLD` call with the same arguments and get the same result.
/// Every process holds the input matrix and the resulting vectors; SLEPc's copy of the matrix, the
/// multigrid hierarchy and the work vectors, which are many times larger, are distributed by rows.
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
      internal::Slepc_lobpcg<GoFurther> slepc(distributed, grids.multigrid(),
                                              above_rounding(options, K), go_further);
      x = slepc.run(x);
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
