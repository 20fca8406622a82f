// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_INSTANCES_IMPL_H

// Instantiates the templates of the compiled library, for its own solvers.

#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/parameterization/Least_energy_map_templates.h>

namespace Conformal_geometry_processing {

template class internal::Least_energy_map<Default_solver_traits>;

}  // namespace Conformal_geometry_processing

#endif
