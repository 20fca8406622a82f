// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_TRANSFORMATION_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_TRANSFORMATION_INSTANCES_IMPL_H

// Template instantiations of the compiled library, for its own solvers.

#include <Conformal_geometry_processing/spin/Dirac_line_templates.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction_templates.h>
#include <Conformal_geometry_processing/spin/Spin_transformation_templates.h>

#include <optional>

namespace Conformal_geometry_processing {

template class Poisson_reconstruction<Default_solver_traits>;
template class internal::Spin_derivative<Default_solver_traits>;
template class internal::Dirac_line<Default_solver_traits>;
template class internal::Exactness_residual<Default_solver_traits>;
template class internal::Potential_metric<Default_solver_traits>;
template class internal::Potential_search<Default_solver_traits, Lobpcg_eigensolver_traits>;
template class internal::Scale_search<Default_solver_traits, Lobpcg_eigensolver_traits>;
template internal::Exactness_constraints exactness_constraints<Default_solver_traits>(
    internal::Dirac_system<Default_solver_traits>&,
    const internal::Grounded_solver<Default_solver_traits>&, Eigen::MatrixXd,
    Curvature_potential::On, std::optional<Exactness>);
template internal::Closed_step internal::closed_step(
    Spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>&,
    const Curvature_potential&, const internal::Period_limit&, double, const Dirac_options&,
    const internal::Go_further&);
template class Spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing

#endif
