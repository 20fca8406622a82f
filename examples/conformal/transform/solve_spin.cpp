// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_spin.h"

#include "conformal/process/Failure.h"
#include "conformal/report/verification.h"

#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>
#ifdef CONFORMAL_HAS_OTHER_SOLVERS
#include <Conformal_geometry_processing/linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/templates.h>
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#include <Conformal_geometry_processing/linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>
#endif
#endif
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>

#include <utility>

namespace conformal {
namespace {

template <class SolverTraits>
CGP::Spin_result transformed(const CGP::Mesh_view& mesh, const Spin_problem& problem,
                             const CGP::Spin_transformation_options& own,
                             const CGP::Spin_report::Limits& limits,
                             const CGP::Dirac_options& options, const Go_further& go_further)
{
  CGP::Spin_transformation<SolverTraits> transformation(mesh, own, "spin");
  transformation.limits() = limits;
  return std::move(transformation).transform(problem.rho, options, std::cref(go_further));
}

template <class SolverTraits>
Spin_solution solve_by(const CGP::Mesh_view& mesh, const Spin_problem& problem,
                       const Spin_options& spin, const CGP::Dirac_options& options,
                       const Go_further& go_further)
{
  CGP::Spin_transformation_options own{problem.boundary};
  own.max_period_defect = spin.max_period_defect;
  own.scales = problem.scales;
  own.exact_conformal_class = problem.exact_class;
  if (!problem.closes_loops) own.exactness.reset();
  if (problem.mollification > 0) own.mollification = problem.mollification;
  CGP::Spin_result result =
      problem.minimal ? CGP::spin_to_minimal_surface<SolverTraits>(mesh, own, options, "boundary",
                                                                   std::cref(go_further))
                      : transformed<SolverTraits>(mesh, problem, own, spin_limits(spin.limits),
                                                  options, go_further);
  return {std::move(result.positions), std::move(result.lambda), result.report};
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
#ifdef CONFORMAL_HAS_OTHER_SOLVERS
  if (options.solver == "eigen")
    return solve_by<CGP::Eigen_hermitian_solver_traits>(mesh, problem, options, dirac, go_further);
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
  if (options.solver == "cholmod")
    return solve_by<CGP::Cholmod_hermitian_solver_traits>(mesh, problem, options, dirac,
                                                          go_further);
#endif
#endif
  if (options.solver != "native")
    throw Failure(Exit_code::usage, "this program was built without the solver " + options.solver +
                                        "; try: --solver native");
  return solve_by<CGP::Default_solver_traits>(mesh, problem, options, dirac, go_further);
}

}  // namespace conformal
