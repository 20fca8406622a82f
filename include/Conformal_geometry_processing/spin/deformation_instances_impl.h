// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DEFORMATION_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DEFORMATION_INSTANCES_IMPL_H

// Template instantiations of the compiled library, for its own solvers, of deformations with
// targets.

#include <Conformal_geometry_processing/spin/Conformal_deformation_templates.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation_templates.h>
#include <Conformal_geometry_processing/spin/Position_derivative_templates.h>
#include <Conformal_geometry_processing/spin/Spin_preview_templates.h>
#include <Conformal_geometry_processing/spin/nearest_curvature_difference_templates.h>

namespace Conformal_geometry_processing {

template class internal::Position_derivative<Default_solver_traits>;
template class internal::Position_residual<Default_solver_traits>;
template class internal::Control_point_search<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class internal::Target_search<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class internal::Conformal_deformation<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class internal::Spin_preview<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class Nearest_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>;
template Curvature_potential
nearest_curvature_difference<Default_solver_traits, Lobpcg_eigensolver_traits>(
    const Mesh_view&, const Points&, double, const Dirac_options&, const internal::Go_further&,
    const std::string&);

}  // namespace Conformal_geometry_processing

#endif
