// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/adapters/Petsc_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <petscksp.h>

#include <optional>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

// Conjugate gradients for a Hermitian matrix, until the norm that belongs to the preconditioner is
// 1e-13 of that of the right-hand side.
class Petsc_conjugate_gradients {
 public:
  // set_preconditioner(pc) is called once
  template <class Set>
  Petsc_conjugate_gradients(Mat matrix, const Set& set_preconditioner)
  {
    check_petsc(KSPCreate(PETSC_COMM_WORLD, m_ksp.renew()));
    check_petsc(KSPSetOptionsPrefix(m_ksp.get(), "conformal_"));
    check_petsc(KSPSetOperators(m_ksp.get(), matrix, matrix));
    check_petsc(KSPSetType(m_ksp.get(), KSPCG));
    check_petsc(KSPSetNormType(m_ksp.get(), KSP_NORM_NATURAL));
    check_petsc(KSPSetTolerances(m_ksp.get(), 1e-13, 1e-300, 1e10, 2000));
    set_preconditioner(preconditioner());
    check_petsc(KSPSetFromOptions(m_ksp.get()));
    check_petsc(KSPSetUp(m_ksp.get()));
  }

  PC preconditioner() const
  {
    PC pc = nullptr;
    check_petsc(KSPGetPC(m_ksp.get(), &pc));
    return pc;
  }

  void apply(Vec b, Vec x) const { check_petsc(PCApply(preconditioner(), b, x)); }

  Solver_status solve(Vec b, Vec x) const
  {
    check_petsc(KSPSolve(m_ksp.get(), b, x));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    check_petsc(KSPGetConvergedReason(m_ksp.get(), &reason));
    if (reason > 0) return Solver_status::success;
    const bool is_indefinite =
        reason == KSP_DIVERGED_INDEFINITE_MAT || reason == KSP_DIVERGED_INDEFINITE_PC;
    return is_indefinite ? Solver_status::not_positive_definite : Solver_status::numerical_issue;
  }

 private:
  Petsc_ksp m_ksp;
};

// Returns the grids of PETSc (GAMG) for a real matrix.
inline Petsc_pc petsc_coarsening(Mat real)
{
  Petsc_pc pc;
  check_petsc(PCCreate(PETSC_COMM_WORLD, pc.renew()));
  check_petsc(PCSetOptionsPrefix(pc.get(), "conformal_grids_"));
  check_petsc(PCSetOperators(pc.get(), real, real));
  check_petsc(PCSetType(pc.get(), PCGAMG));
  check_petsc(PCSetFromOptions(pc.get()));
  check_petsc(PCGAMGSetAggressiveLevels(pc.get(), 0));  // has no effect before the options
  check_petsc(PCSetUp(pc.get()));
  return pc;
}

// Replaces every entry by its product with the identity matrix of `width` rows.
inline Petsc_mat with_blocks(Mat P, int width)
{
  Petsc_mat view, blocks;
  check_petsc(MatCreateMAIJ(P, width, view.renew()));
  check_petsc(MatConvert(view.get(), MATAIJ, MAT_INITIAL_MATRIX, blocks.renew()));
  return blocks;
}

// Sets pc, of a Hermitian matrix with n rows of `width` complex numbers each, to smoothed
// aggregation multigrid. PETSc coarsens a real matrix of n rows, which is distributed in the same
// way, the real part: for the complex matrix itself, GAMG would form P^T A P with complex
// interpolations P, which is not Hermitian.
//
// Based on measurements with the Dirac matrix, the smoother is PETSc's default, Chebyshev
// polynomials of SOR. SOR alone need not be definite when it runs on several processes: with 5
// processes LOBPCG did not converge in 500 iterations. Coarsening on the graph instead of its
// square halves the number of iterations. Block ICC takes ten times as many.
inline void set_petsc_multigrid(PC pc, Mat real, int width)
{
  const Petsc_pc coarsening = petsc_coarsening(real);
  PetscInt levels = 1;
  check_petsc(PCMGGetLevels(coarsening.get(), &levels));
  check_petsc(PCSetType(pc, PCMG));
  check_petsc(PCMGSetLevels(pc, levels, nullptr));
  check_petsc(PCMGSetGalerkin(pc, PC_MG_GALERKIN_BOTH));
  for (PetscInt level = 1; level < levels; ++level) {
    Mat P = nullptr;
    check_petsc(PCMGGetInterpolation(coarsening.get(), level, &P));
    const Petsc_mat blocks = with_blocks(P, width);
    check_petsc(PCMGSetInterpolation(pc, level, blocks.get()));
  }
}

// Number of entries on all levels divided by that of the matrix
inline double multigrid_complexity(PC pc)
{
  PetscReal unknowns = 1, entries = 1;
  check_petsc(PCMGGetGridComplexity(pc, &unknowns, &entries));
  return entries;
}

/// \brief Conjugate gradients with the algebraic multigrid of PETSc (GAMG): its matrix, grids and
/// vectors are divided among the processes of `PETSC_COMM_WORLD`; what calls it, with the mesh, the
/// matrix and all results, is replicated on each of them. `conformal-mpi` divides these as well.
///
/// "Factorization" means the setup of the multigrid hierarchy; there is no factor. The program
/// calls `SlepcInitialize()` before and `SlepcFinalize()` after all other functions, which are
/// collective: all processes call them with the same arguments and get the same results. The
/// ordering determines which rows are consecutive, and each process owns a range of rows; the
/// default is `breadth_first_ordering()`. Indefinite matrices are detected from their diagonal in
/// `factorize()`, or else in `solve()`.
///
/// `solve()` iterates until the preconditioned residual norm is 1e-13 of the initial one.
///
/// \cgalModels{SparseHermitianSolver}
template <class Scalar_>
class Petsc_hermitian_solver {
 public:
  using Scalar = Scalar_;
  using FT = typename Scalar_traits<Scalar>::FT;

  Petsc_hermitian_solver() = default;
  Petsc_hermitian_solver(const Petsc_hermitian_solver&) = delete;
  Petsc_hermitian_solver& operator=(const Petsc_hermitian_solver&) = delete;

  Solver_status analyze(const Sparse_pattern& pattern)
  {
    return internal::guarded([&] { return analyze(pattern, breadth_first_ordering(pattern)); });
  }

  Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order)
  {
    return attempt([&] {
      m_matrix.reset();
      m_grids.reset();
      const bool fits = order.size() == static_cast<std::size_t>(pattern.size()) &&
                        !inverse_permutation(order).empty();
      if (!fits || !internal::petsc_is_running()) return Solver_status::wrong_state;
      m_entries = pattern.size_of_entries();
      m_matrix.emplace(pattern, order);
      m_b = m_matrix->make_vector();
      m_x = m_matrix->make_vector();
      return Solver_status::success;
    });
  }

  /// Ignores the positions
  Solver_status analyze_with_positions(const Sparse_pattern& pattern, const Eigen::Matrix3Xd&)
  {
    return analyze(pattern);
  }

  /// Distributes the rows like the other solver
  template <class Other>
  Solver_status analyze_like(const Sparse_pattern& pattern, const Other& other)
  {
    return analyze(pattern, other.ordering());
  }

  const Ordering& ordering() const { return m_matrix ? m_matrix->ordering() : m_no_ordering; }

  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    return attempt([&] {
      if (!fits(A, shift)) return Solver_status::wrong_state;
      m_grids.reset();
      if (!is_finite(A) || !shift.allFinite()) return Solver_status::numerical_issue;
      for (int j = 0; j < A.size(); ++j)
        if (!(A.diagonal(j) + (shift.size() > 0 ? shift[j] : 0) > 0))
          return Solver_status::not_positive_definite;
      m_matrix->set_values(A, shift);
      const Petsc_matrix<FT> real = real_part(A, shift);
      m_grids.emplace(m_matrix->get(), [&](PC pc) {
        set_petsc_multigrid(pc, real.get(), Petsc_matrix<Scalar>::width);
      });
      return Solver_status::success;
    });
  }

  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return for_each_column(b, x, [&] { return m_grids->solve(m_b.get(), m_x.get()); });
  }

  /// Applies one multigrid cycle
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return for_each_column(b, x, [&] {
      m_grids->apply(m_b.get(), m_x.get());
      return Solver_status::success;
    });
  }

  /// Sizes of the matrix and all multigrid levels together; "flops" counts one product with each of
  /// them, of which a solve takes some hundred
  Solver_statistics statistics() const
  {
    Solver_statistics s;
    if (!m_matrix) return s;
    const double entries = m_entries * (m_grids ? multigrid_complexity(multigrid()) : 1.);
    const double numbers = Petsc_matrix<Scalar>::width * Petsc_matrix<Scalar>::width;
    s.factor_entries = m_entries;
    s.flops = 8 * 2 * numbers * entries;  // both triangles, complex arithmetic
    s.bytes = 2 * numbers * entries * (sizeof(PetscScalar) + sizeof(PetscInt));
    return s;
  }

  /// The multigrid preconditioner, for eigensolvers of SLEPc; null before `factorize()`
  PC multigrid() const { return m_grids ? m_grids->preconditioner() : nullptr; }

 private:
  template <class Action>
  static Solver_status attempt(const Action& action)
  {
    const internal::Quiet_petsc quiet;
    return internal::guarded([&] {
      try {
        return action();
      } catch (const Solver_error&) {
        return Solver_status::numerical_issue;
      }
    });
  }

  bool fits(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift) const
  {
    return m_matrix && A.size() == m_matrix->size() && A.pattern().size_of_entries() == m_entries &&
           (shift.size() == 0 || shift.size() == A.size());
  }

  static bool is_finite(const Hermitian_sparse_matrix<Scalar>& A)
  {
    bool is_finite = true;
    A.for_each_entry([&](int, int, const Scalar& a) {
      is_finite = is_finite && Complex_embedding<Scalar>::block(a).allFinite();
    });
    return is_finite;
  }

  Petsc_matrix<FT> real_part(const Hermitian_sparse_matrix<Scalar>& A,
                             const Vector<FT>& shift) const
  {
    Hermitian_sparse_matrix<FT> real(A.shared_pattern());
    for (int k = 0; k < m_entries; ++k) real.value(k) = Scalar_traits<Scalar>::real(A.value(k));
    Petsc_matrix<FT> distributed(A.pattern(), ordering());
    distributed.set_values(real, shift);
    return distributed;
  }

  template <class Action>
  Solver_status for_each_column(const Block<Scalar>& b, Block<Scalar>& x,
                                const Action& action) const
  {
    return attempt([&] {
      if (!m_grids || b.rows() != m_matrix->size()) return Solver_status::wrong_state;
      Block<Scalar> solution(b.rows(), b.cols());
      for (Eigen::Index c = 0; c < b.cols(); ++c) {
        m_matrix->to_petsc(b, c, m_b.get());
        const Solver_status status = action();
        if (status != Solver_status::success) return status;
        m_matrix->from_petsc(m_x.get(), c, solution);
      }
      x = std::move(solution);
      return Solver_status::success;
    });
  }

  int m_entries = 0;
  Ordering m_no_ordering;
  std::optional<Petsc_matrix<Scalar>> m_matrix;
  std::optional<internal::Petsc_conjugate_gradients> m_grids;
  internal::Petsc_vec m_b, m_x;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Solvers of PETSc over MPI; link the component `slepc`.
/// \cgalModels{SparseHermitianSolverTraits}
struct Petsc_hermitian_solver_traits {
  template <class Scalar>
  using Solver = internal::Petsc_hermitian_solver<Scalar>;
};

}  // namespace Conformal_geometry_processing
