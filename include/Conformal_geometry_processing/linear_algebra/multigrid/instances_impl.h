// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_INSTANCES_IMPL_H

// Template instantiations of the compiled library, for its own solvers.

#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_cycle_templates.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_level_templates.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_solver_templates.h>

namespace Conformal_geometry_processing {

template class internal::Multigrid_level<float>;
template class internal::Multigrid_level<Quaternion<float>>;
template class internal::Multigrid_cycle<float>;
template class internal::Multigrid_cycle<Quaternion<float>>;
template class internal::Multigrid_solver<double>;
template class internal::Multigrid_solver<Quaternion<double>>;

}  // namespace Conformal_geometry_processing

#endif
