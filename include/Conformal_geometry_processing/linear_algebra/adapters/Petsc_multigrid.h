// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/adapters/Petsc_handle.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>

#include <petscksp.h>

namespace Conformal_geometry_processing::internal {

// Smoothed aggregation multigrid for a Hermitian matrix with complex blocks as entries, and
// conjugate gradients preconditioned by it. PETSc (GAMG) coarsens a real matrix with one number per
// block, the real part: for the complex matrix itself, GAMG would form P^T A P with complex
// interpolations P, which is not Hermitian.
//
// Based on measurements with the Dirac matrix, the smoother is PETSc's default, Chebyshev
// polynomials of SOR. SOR alone need not be definite when it runs on several processes: with 5
// processes LOBPCG did not converge in 500 iterations. Coarsening on the graph instead of its
// square halves the number of iterations. Block ICC takes ten times as many.
class Petsc_multigrid {
 public:
  // real: n rows; matrix: n rows of `width` numbers each, distributed in the same way
  Petsc_multigrid(Mat matrix, Mat real, int width)
  {
    check_petsc(KSPCreate(PETSC_COMM_WORLD, m_ksp.renew()));
    check_petsc(KSPSetOptionsPrefix(m_ksp.get(), "conformal_"));
    check_petsc(KSPSetOperators(m_ksp.get(), matrix, matrix));
    check_petsc(KSPSetType(m_ksp.get(), KSPCG));
    check_petsc(KSPSetNormType(m_ksp.get(), KSP_NORM_NATURAL));
    check_petsc(KSPSetTolerances(m_ksp.get(), 1e-13, 1e-300, 1e10, 2000));
    set_grids(real, width);
    check_petsc(KSPSetFromOptions(m_ksp.get()));
    check_petsc(KSPSetUp(m_ksp.get()));
  }

  PC multigrid() const
  {
    PC pc = nullptr;
    check_petsc(KSPGetPC(m_ksp.get(), &pc));
    return pc;
  }

  void apply(Vec b, Vec x) const { check_petsc(PCApply(multigrid(), b, x)); }

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

  // Number of entries on all levels divided by that of the matrix
  double complexity() const
  {
    PetscReal unknowns = 1, entries = 1;
    check_petsc(PCMGGetGridComplexity(multigrid(), &unknowns, &entries));
    return entries;
  }

 private:
  void set_grids(Mat real, int width)
  {
    const Petsc_pc coarsening = coarsen(real);
    PetscInt levels = 1;
    check_petsc(PCMGGetLevels(coarsening.get(), &levels));
    check_petsc(PCSetType(multigrid(), PCMG));
    check_petsc(PCMGSetLevels(multigrid(), levels, nullptr));
    check_petsc(PCMGSetGalerkin(multigrid(), PC_MG_GALERKIN_BOTH));
    for (PetscInt level = 1; level < levels; ++level) {
      Mat P = nullptr;
      check_petsc(PCMGGetInterpolation(coarsening.get(), level, &P));
      const Petsc_mat blocks = with_blocks(P, width);
      check_petsc(PCMGSetInterpolation(multigrid(), level, blocks.get()));
    }
  }

  static Petsc_pc coarsen(Mat real)
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
  static Petsc_mat with_blocks(Mat P, int width)
  {
    Petsc_mat view, blocks;
    check_petsc(MatCreateMAIJ(P, width, view.renew()));
    check_petsc(MatConvert(view.get(), MATAIJ, MAT_INITIAL_MATRIX, blocks.renew()));
    return blocks;
  }

  Petsc_ksp m_ksp;
};

}  // namespace Conformal_geometry_processing::internal
