// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_TRANSFORMATION_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_TRANSFORMATION_INSTANCES_IMPL_H

// The templates that the compiled library contains, for its own solvers.

#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/delaunay_boundary.h>
#include <Conformal_geometry_processing/operators/delaunay_operators.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation_templates.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction_templates.h>
#include <Conformal_geometry_processing/spin/Robust_spin_transformation_templates.h>
#include <Conformal_geometry_processing/spin/Spin_transformation_templates.h>

namespace Conformal_geometry_processing {

template class Poisson_reconstruction<Default_solver_traits, Mesh_view>;
template class Poisson_reconstruction<Default_solver_traits, Delaunay_view>;
template class Spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class Robust_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class Nearest_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing

#endif
