// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_mesh.h"
#include "Distributed_solver.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace conformal::mpi {

/// \brief The spins of a surface with a free boundary: (X + W) lambda = W 1 with the weights W of
/// `CGP::nearness_weight()`, by conjugate gradients with a solver of `plan`; their numbers go into
/// the report. Collective.
///
/// \param rho |V| of the mesh of the part, in 1/length \param areas of the same vertices
/// \throw CGP::Solver_error if PETSc fails
CGP::Quaternion_vector<double> spins_with_free_boundary(const Distributed_mesh& mesh,
                                                        const Solution_plan& plan,
                                                        const Eigen::VectorXd& rho,
                                                        const Eigen::VectorXd& areas,
                                                        CGP::Spin_report& report);

}  // namespace conformal::mpi
