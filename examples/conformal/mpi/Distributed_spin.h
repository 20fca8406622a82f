// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_eigenvector.h"
#include "Distributed_mesh.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <Eigen/Core>

#include <optional>

namespace conformal::mpi {

struct Spin_request {
  std::optional<double> bound = std::nullopt;  ///< see `CGP::internal::Scale_control`
  CGP::Dirac_options dirac = {};               ///< without a bound
  CGP::Spin_report::Limits limits = {};
};

/// the new surface, of the own vertices, and the report, which every process has
struct Distributed_result {
  CGP::Points positions;
  Eigen::VectorXd quality;  ///< the quasi-conformal error
  CGP::Spin_report report;
};

/// \brief The spin transformation of a surface by rho [CGP (5.3)-(5.5)], on all processes; each has
/// only its part of X, of all vectors and of the surface. A boundary is free, and handles and holes
/// are not kept closed. Collective.
///
/// \param plan of the same mesh \param rho |V| of the mesh of the part, in 1/length
/// \param start of the way, which has steps on closed surfaces, and with a bound
/// \param save is told where it is, every now and then, on all processes
/// \param go_further asked on each process before each iteration
/// \throw CGP::Solver_error if PETSc or SLEPc fails
Distributed_result transform(const Distributed_mesh& mesh, const Solution_plan& plan,
                             const Eigen::VectorXd& rho, const Spin_request& request,
                             const Search_state& start, const Save& save,
                             const Go_further& go_further);

}  // namespace conformal::mpi
