// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_INSTANCES_IMPL_H

// The templates that the compiled library contains, for its own solvers.

#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/delaunay_boundary.h>
#include <Conformal_geometry_processing/operators/delaunay_operators.h>
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem_templates.h>
#include <Conformal_geometry_processing/spin/Dirac_equation_templates.h>
#include <Conformal_geometry_processing/spin/Dirac_search_templates.h>
#include <Conformal_geometry_processing/spin/Prescribed_directions_templates.h>
#include <Conformal_geometry_processing/spin/Prescribed_positions_templates.h>
#include <Conformal_geometry_processing/spin/Reduced_dirac_equation_templates.h>
#include <Conformal_geometry_processing/spin/Surface_dirac_equation_templates.h>

namespace Conformal_geometry_processing {

template class Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Mesh_view>;
template class Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Delaunay_view>;
template class internal::Dirac_search<
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Mesh_view>>;
template class internal::Dirac_search<
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Delaunay_view>>;
template class Dirac_equation<Default_solver_traits, Lobpcg_eigensolver_traits, Mesh_view>;
template class Dirac_equation<Default_solver_traits, Lobpcg_eigensolver_traits, Delaunay_view>;
template class Prescribed_directions<Default_solver_traits, Mesh_view>;
template class Prescribed_directions<Default_solver_traits, Delaunay_view>;
template class Prescribed_positions<
    Default_solver_traits,
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Mesh_view>>;
template class Prescribed_positions<
    Default_solver_traits,
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Delaunay_view>>;
template class Reduced_dirac_equation<
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Mesh_view>,
    Prescribed_directions<Default_solver_traits, Mesh_view>>;
template class Reduced_dirac_equation<
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Delaunay_view>,
    Prescribed_directions<Default_solver_traits, Delaunay_view>>;
template class Surface_dirac_equation<Default_solver_traits, Lobpcg_eigensolver_traits, Mesh_view>;
template class Surface_dirac_equation<Default_solver_traits, Lobpcg_eigensolver_traits,
                                      Delaunay_view>;

}  // namespace Conformal_geometry_processing

#endif
