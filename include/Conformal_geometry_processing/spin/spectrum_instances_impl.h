// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPECTRUM_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPECTRUM_INSTANCES_IMPL_H

// Template instantiations of the compiled library, for its own solvers.

#include <Conformal_geometry_processing/spin/Conformal_shape_space_templates.h>
#include <Conformal_geometry_processing/spin/Dirac_spectral_problem_templates.h>

namespace Conformal_geometry_processing {

template class internal::Dirac_spectral_problem<Default_solver_traits>;
template class internal::Conformal_shape_space<Default_solver_traits>;

}  // namespace Conformal_geometry_processing

#endif
