// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>

#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

#include <cmath>
#include <optional>
#include <utility>

namespace Conformal_geometry_processing {

internal::Constraint_basis internal::Exactness_constraints::basis() const
{
  internal::Constraint_basis basis(areas);
  if (!constants_have_effect) basis.add(Eigen::VectorXd::Ones(areas.size()));
  basis.add(functions);
  return basis;
}

double internal::Exactness_constraints::period_defect(const Eigen::MatrixX3d& edges) const
{
  if (forms.size() == 0) return 0;
  // Uses |w|, because w is negative opposite large angles and then defines no norm.
  const double total = weights.cwiseAbs().dot(edges.rowwise().squaredNorm());
  return forms.coefficients(weights, edges).norm() / std::sqrt(total);
}

internal::Exactness_constraints exactness_constraints(internal::Dirac_system& system,
                                                      const internal::Grounded_solver& laplacian,
                                                      Eigen::MatrixXd generators,
                                                      Curvature_potential::On on,
                                                      std::optional<Exactness> version)
{
  const Surface_ref& surface = system.surface();
  internal::Exactness_constraints c;
  c.on = on;
  c.constants_have_effect = !system.is_self_adjoint();
  c.areas = curvature_areas(surface, on);
  c.functions = Eigen::MatrixXd(c.areas.size(), 0);
  if (generators.cols() == 0) return c;
  c.weights = cotan_weights(surface);
  c.forms = Hodge_decomposition(surface, std::move(generators), laplacian).harmonic_basis();
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
