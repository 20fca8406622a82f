// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_INSTANCES_IMPL_H

// The templates that the compiled library contains, for its own solvers.

#include <Conformal_geometry_processing/flow/Closing_constraints_templates.h>
#include <Conformal_geometry_processing/flow/Closing_spin_transformation_templates.h>
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow_templates.h>
#include <Conformal_geometry_processing/flow/Constrained_direction_templates.h>
#include <Conformal_geometry_processing/flow/Curvature_filter_templates.h>
#include <Conformal_geometry_processing/flow/Moving_delaunay_view_templates.h>
#include <Conformal_geometry_processing/flow/Moving_mesh_templates.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/delaunay_boundary.h>
#include <Conformal_geometry_processing/operators/delaunay_operators.h>

namespace Conformal_geometry_processing {

template class Moving_mesh<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class Moving_delaunay_view<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class Closing_constraints<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class Curvature_filter<Default_solver_traits>;
template class Constrained_direction<Default_solver_traits, Lobpcg_eigensolver_traits,
                                     Willmore_direction>;
template class Conformal_willmore_flow<Default_solver_traits, Lobpcg_eigensolver_traits,
                                       Willmore_direction>;

// A constructor belongs to one kind of surface or the other.
template Closing_spin_transformation<
    Default_solver_traits, Lobpcg_eigensolver_traits,
    Moving_mesh>::Closing_spin_transformation(const Mesh_view&, const Closing_options&,
                                              const std::string&);
template Closing_spin_transformation<
    Default_solver_traits, Lobpcg_eigensolver_traits,
    Moving_mesh>::Closing_spin_transformation(const Mesh_view&, const Closing_options&,
                                              const Boundary_condition&, const std::string&);
template Closing_spin_transformation<
    Default_solver_traits, Lobpcg_eigensolver_traits,
    Moving_delaunay_view>::Closing_spin_transformation(const Mesh_view&, const Closing_options&,
                                                       const Boundary_condition&, double,
                                                       const std::string&);
template Spin_result Closing_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits,
                                                 Moving_mesh>::transform(const Curvature_potential&,
                                                                         const Dirac_options&,
                                                                         const Go_further&) &&;
template Spin_result
Closing_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits,
                            Moving_delaunay_view>::transform(const Curvature_potential&,
                                                             const Dirac_options&,
                                                             const Go_further&) &&;

}  // namespace Conformal_geometry_processing

#endif
