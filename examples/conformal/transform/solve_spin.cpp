// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_spin.h"

#include "conformal/process/Failure.h"
#include "conformal/report/verification.h"

#include <Conformal_geometry_processing/surfaces/minimal_surface.h>
#ifdef CONFORMAL_HAS_OTHER_SOLVERS
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#include <Quaternionic_linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>
#endif
#endif

namespace conformal {

CGP::Spin_solvers solvers_named(const std::string& name)
{
#ifdef CONFORMAL_HAS_OTHER_SOLVERS
  if (name == "eigen") return CGP::Eigen_hermitian_solver_traits();
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
  if (name == "cholmod") return CGP::Cholmod_hermitian_solver_traits();
#endif
#endif
  if (name == "native") return {};
  throw Failure(Exit_code::usage, "this program was built without the solver " + name +
                                      "; try: --advanced solver=native");
}

CGP::Spin_result solve_spin(const CGP::Mesh_view& mesh, const Spin_problem& problem,
                            const Go_further& go_further)
{
  if (problem.minimal)
    return CGP::spin_to_minimal_surface(mesh, problem.request, "boundary", go_further);
  return CGP::Spin_transformation(mesh, problem.request, "spin").transform(problem.rho, go_further);
}

}  // namespace conformal
