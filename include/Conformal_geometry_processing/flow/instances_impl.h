// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_INSTANCES_IMPL_H

// Template instantiations of the compiled library, for its own solvers.

#include <Conformal_geometry_processing/flow/Conformal_willmore_flow_templates.h>

namespace Conformal_geometry_processing {

template class internal::Constrained_direction<Default_solver_traits, Lobpcg_eigensolver_traits,
                                               Willmore_direction>;
template class Conformal_willmore_flow<Default_solver_traits, Lobpcg_eigensolver_traits,
                                       Willmore_direction>;

}  // namespace Conformal_geometry_processing

#endif
