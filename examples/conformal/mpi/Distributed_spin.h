// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_mesh.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <functional>

namespace conformal::mpi {

/// where the way to rho is, from which it can be gone on
struct Branch_state {
  double t = 0, step = 1, gamma = 0;
  Eigen::MatrixXd spins = {};  ///< 4 x own vertices; empty: 1
};

/// the new surface, of the own vertices, and the report, which every process has
struct Distributed_result {
  CGP::Points positions;
  Eigen::VectorXd quality;  ///< the quasi-conformal error
  CGP::Spin_report report;
};

/// \brief The spin transformation of a closed surface without handles by rho [CGP (5.3)-(5.5)],
/// without a bound on lengths, on all processes; each has only its part of X, of all vectors and of
/// the surface.
///
/// lambda is the smallest eigenvector of X for rho + gamma with gamma its own quotient, as that of
/// `CGP::Spin_transformation` is, on the branch of lambda = 1, found by the LOBPCG of SLEPc with
/// the multigrid of PETSc. Collective.
///
/// \param rho |V| of the mesh of the part, in 1/length
/// \param start of the way
/// \param save is told where it is, every now and then, on all processes
/// \param go_further asked on each process before each iteration
/// \throw CGP::Solver_error if PETSc or SLEPc fails
Distributed_result transform(
    const Distributed_mesh& mesh, const Eigen::VectorXd& rho, const CGP::Dirac_options& options,
    const CGP::Spin_report::Limits& limits, const Branch_state& start,
    const std::function<void(const Branch_state&)>& save,
    const std::function<bool(const CGP::Eigensolver_progress&)>& go_further);

}  // namespace conformal::mpi
