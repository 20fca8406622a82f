// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_INSTANCES_IMPL_H

// Template instantiations of the compiled library, for its own solvers.

#include <Conformal_geometry_processing/spin/solve_dirac_equation_templates.h>

namespace Conformal_geometry_processing {

template class internal::Prescribed_directions<Default_solver_traits>;
template class internal::Prescribed_positions<Default_solver_traits>;
template class internal::Dirac_system<Default_solver_traits>;
template class internal::Dirac_branch<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class internal::Directions_search<Default_solver_traits>;
template internal::Dirac_solution solve_dirac_equation<Lobpcg_eigensolver_traits>(
    internal::Dirac_system<Default_solver_traits>&, const Curvature_potential&,
    const Dirac_options&, const internal::Go_further&, const internal::Is_too_far&);
template internal::Dirac_solution internal::correct_dirac_solution<Lobpcg_eigensolver_traits>(
    internal::Dirac_system<Default_solver_traits>&, const Curvature_potential&,
    const internal::Dirac_solution&, const Dirac_options&, const internal::Go_further&);

}  // namespace Conformal_geometry_processing

#endif
