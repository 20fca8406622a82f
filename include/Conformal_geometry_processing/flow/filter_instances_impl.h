// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_FILTER_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_FILTER_INSTANCES_IMPL_H

// Template instantiations of the compiled library, for its own solvers.

#include <Conformal_geometry_processing/flow/Curvature_filter_templates.h>

namespace Conformal_geometry_processing {

template class internal::Curvature_filter<Default_solver_traits>;

}  // namespace Conformal_geometry_processing

#endif
