// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_mesh.h"
#include "Distributed_solver.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace conformal::mpi {

/// where a search is, from which it can be gone on
struct Search_state {
  std::vector<double> numbers = {};  ///< in an order that the search knows
  Eigen::MatrixXd values = {};       ///< a column for each own vertex; none: at the start
};

using Go_further = std::function<bool(const CGP::Eigensolver_progress&)>;
using Save = std::function<void(const Search_state&)>;

/// \brief The smallest eigenvector of X of a closed surface, for rho + gamma with gamma its own
/// quotient, as that of `CGP::Spin_transformation` is, on the branch of lambda = 1, found by the
/// LOBPCG of SLEPc with a solver of `plan`; its numbers go into the report. Collective.
///
/// \param plan of the same mesh \param rho |V| of the mesh of the part, in 1/length \param areas of the same vertices
/// \param start, save, go_further see `transform()`
/// \throw CGP::Solver_error if PETSc or SLEPc fails
CGP::Quaternion_vector<double> eigenvector(const Distributed_mesh& mesh, const Solution_plan& plan,
                                           const Eigen::VectorXd& rho, const Eigen::VectorXd& areas,
                                           const CGP::Dirac_options& options,
                                           const Search_state& start, const Save& save,
                                           const Go_further& go_further, CGP::Spin_report& report);

}  // namespace conformal::mpi
