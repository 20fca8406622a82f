// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_EXACTNESS_CONSTRAINTS_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_EXACTNESS_CONSTRAINTS_TEMPLATES_H

#include <Conformal_geometry_processing/forms/Hodge_decomposition_templates.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Dirac_system_templates.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>

#include <Eigen/Core>

#include <optional>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits>
internal::Exactness_constraints exactness_constraints(
    internal::Dirac_system<SolverTraits>& system,
    const internal::Grounded_solver<SolverTraits>& laplacian, Eigen::MatrixXd generators,
    Curvature_potential::On on, std::optional<Exactness> version)
{
  const Surface_ref& surface = system.surface();
  internal::Exactness_constraints c;
  c.on = on;
  c.constants_have_effect = !system.is_self_adjoint();
  c.areas = curvature_areas(surface, on);
  c.functions = Eigen::MatrixXd(c.areas.size(), 0);
  if (generators.cols() == 0) return c;
  c.weights = cotan_weights(surface);
  c.forms =
      Hodge_decomposition<SolverTraits>(surface, std::move(generators), laplacian).harmonic_basis();
  const bool is_thesis = system.is_closed() && version == Exactness::thesis;
  if (!is_thesis) c.forms.fields.clear();
  if (!version) return c;
  const double tolerance = 1e-8;  // far below the periods of second order that any edit leaves
  system.prepare_response();
  c.factorizations = 1;
  c.functions = exactness_functions(
      surface, c.forms,
      [&](const Block<Quaternion<double>>& b) { return system.response(b, tolerance, c.solves); },
      on, system.coefficients(), is_thesis ? Exactness::thesis : Exactness::adjoint);
  return c;
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template internal::Exactness_constraints exactness_constraints<Default_solver_traits>(
    internal::Dirac_system<Default_solver_traits>&,
    const internal::Grounded_solver<Default_solver_traits>&, Eigen::MatrixXd,
    Curvature_potential::On, std::optional<Exactness>);

}  // namespace Conformal_geometry_processing
#endif

#endif
