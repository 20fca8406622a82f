// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_TEMPLATES_H

/// \file templates.h
/// \brief The definitions of all templates: to be included before calls with user-defined solvers,
/// eigensolvers or flow directions. The library contains the instances of its own ones.

#include <Conformal_geometry_processing/flow/Conformal_willmore_flow_templates.h>
#include <Conformal_geometry_processing/flow/Constrained_direction_templates.h>
#include <Conformal_geometry_processing/flow/Curvature_filter_templates.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition_templates.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_eigen_decomposition_templates.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Dirichlet_solver_templates.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Grounded_solver_templates.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_cycle_templates.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_level_templates.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_solver_templates.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Real_reduced_solver_templates.h>
#include <Conformal_geometry_processing/parameterization/Least_energy_map_templates.h>
#include <Conformal_geometry_processing/spin/Conformal_deformation_templates.h>
#include <Conformal_geometry_processing/spin/Conformal_shape_space_templates.h>
#include <Conformal_geometry_processing/spin/Dirac_branch_templates.h>
#include <Conformal_geometry_processing/spin/Dirac_spectral_problem_templates.h>
#include <Conformal_geometry_processing/spin/Dirac_system_templates.h>
#include <Conformal_geometry_processing/spin/Directions_search_templates.h>
#include <Conformal_geometry_processing/spin/Exact_steps_templates.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints_templates.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation_templates.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction_templates.h>
#include <Conformal_geometry_processing/spin/Prescribed_directions_templates.h>
#include <Conformal_geometry_processing/spin/Prescribed_positions_templates.h>
#include <Conformal_geometry_processing/spin/Spin_transformation_templates.h>
#include <Conformal_geometry_processing/spin/nearest_curvature_difference_templates.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation_templates.h>
#include <Conformal_geometry_processing/surfaces/associated_family_templates.h>

namespace Conformal_geometry_processing {
namespace internal {

/// Complete if this file is included, see `require_templates()`
template <class T>
struct Templates_are_included {};

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
