// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_spin.h"

#include "conformal/process/Failure.h"
#include "conformal/report/verification.h"

#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>
#ifdef CONFORMAL_HAS_OTHER_SOLVERS
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#include <Quaternionic_linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>
#endif
#endif

#include <string>
#include <utility>

namespace conformal {
namespace {

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

CGP::Spin_transformation_options options_of(const Spin_problem& problem, const Spin_options& spin)
{
  CGP::Spin_transformation_options own{problem.boundary};
  own.max_period_defect = spin.max_period_defect;
  own.scales = problem.scales;
  own.exact_conformal_class = problem.exact_class;
  own.solvers = solvers_named(spin.solver);
  if (!problem.closes_loops) own.exactness.reset();
  if (problem.mollification > 0) own.mollification = problem.mollification;
  return own;
}

}  // namespace

Spin_solution solve_spin(const CGP::Mesh_view& mesh, const Spin_problem& problem,
                         const Spin_options& options, const Common_options& common,
                         const Go_further& go_further)
{
  CGP::Dirac_options dirac;
  dirac.problem = options.problem == Eigenproblem::generalized
                      ? CGP::Dirac_options::Eigenproblem::generalized
                      : CGP::Dirac_options::Eigenproblem::standard;
  dirac.tolerance = common.tolerance;
  dirac.random_seed = common.seed;
  const CGP::Spin_transformation_options own = options_of(problem, options);
  CGP::Spin_result result;
  if (problem.minimal) {
    result = CGP::spin_to_minimal_surface(mesh, own, dirac, "boundary", go_further);
  } else {
    CGP::Spin_transformation transformation(mesh, own, "spin");
    transformation.limits() = spin_limits(options.limits);
    result = std::move(transformation).transform(problem.rho, dirac, go_further);
  }
  return {std::move(result.positions), std::move(result.lambda), result.report};
}

}  // namespace conformal
