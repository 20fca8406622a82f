// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <algorithm>
#include <utility>

namespace Conformal_geometry_processing {

internal::Constraint_basis::Constraint_basis(Eigen::VectorXd areas)
    : m_areas(std::move(areas)), m_basis(m_areas.size(), 0)
{}

void internal::Constraint_basis::add(Eigen::MatrixXd functions)
{
  Eigen::MatrixXd group = weighted_orthonormalization(std::move(functions), m_areas);
  const Eigen::Index rank = m_basis.cols();
  m_basis.conservativeResize(Eigen::NoChange, rank + group.cols());
  m_basis.rightCols(group.cols()) = group;
  group.resize(0, 0);
  m_basis = weighted_orthonormalization(std::move(m_basis), m_areas);
}

Eigen::VectorXd internal::Constraint_basis::project_out(Eigen::VectorXd v) const
{
  return Conformal_geometry_processing::project_out(m_basis, m_areas, std::move(v));
}

internal::Constraint_basis internal::Exactness_constraints::basis() const
{
  internal::Constraint_basis basis(areas);
  if (!constants_have_effect) basis.add(Eigen::VectorXd::Ones(areas.size()));
  basis.add(functions);
  return basis;
}

double internal::Exactness_constraints::period_defect(const Eigen::MatrixX3d& edges) const
{
  if (!forms) return 0;
  // Uses |w|, because w is negative opposite large angles and then defines no norm.
  const double total = weights.cwiseAbs().dot(edges.rowwise().squaredNorm());
  return forms->coefficients(edges).norm() / std::sqrt(total);
}

internal::Exactness_constraints exactness_constraints(internal::Dirac_system& system,
                                                      const internal::Grounded_solver& laplacian,
                                                      Eigen::MatrixXd generators,
                                                      Curvature_potential::On on,
                                                      std::optional<Exactness> version,
                                                      const internal::Harmonic_part* start)
{
  const Surface_ref& surface = system.surface();
  internal::Exactness_constraints c;
  c.on = on;
  c.constants_have_effect = !system.is_self_adjoint();
  c.areas = curvature_areas(surface, on);
  c.functions = Eigen::MatrixXd(c.areas.size(), 0);
  if (generators.cols() == 0) return c;
  c.weights = cotan_weights(surface);
  const Hodge_decomposition hodge(surface, std::move(generators), laplacian, start);
  c.forms = hodge.harmonic_part();
  if (!version) return c;
  const double tolerance = 1e-5;  // far below the periods of second order that any edit leaves
  const bool is_thesis = system.is_closed() && version == Exactness::thesis;
  system.prepare_response();
  c.factorizations = 1;
  c.functions = exactness_functions(
      surface, hodge.harmonic_basis(),
      [&](const Block<Quaternion<double>>& b) { return system.response(b, tolerance, c.solves); },
      on, system.coefficients(), is_thesis ? Exactness::thesis : Exactness::adjoint);
  return c;
}

double internal::Period_limit::operator()(const Spin_report& report) const
{
  if (maximum) return *maximum;
  const double share_of_distortion = 0.25, rounding = 1e-10, least = 0.002, greatest = 0.02;
  const double distortion = report.conformality.quasi_conformal.mean - 1;
  const double closed = (std::max)({share_of_distortion * distortion, tolerance, rounding, least});
  return (std::min)(closed, greatest);
}

}  // namespace Conformal_geometry_processing
