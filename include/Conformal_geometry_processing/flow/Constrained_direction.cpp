// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Constrained_direction.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <cmath>

namespace Conformal_geometry_processing {

bool internal::Constrained_direction::Result::has_vanished(double tolerance) const
{
  const double norm_of_spheres = std::sqrt(4 * 3.14159265358979323846);
  return share <= tolerance || norm <= tolerance * norm_of_spheres;
}

internal::Constrained_direction::Constrained_direction(Transformation& transformation,
                                                       internal::Curvature_direction_ref direction,
                                                       const Flow_options& options,
                                                       const Volume_constraint* volume,
                                                       std::string function)
    : m_transformation(transformation),
      m_direction(std::move(direction)),
      m_volume(volume),
      m_filter_weight(options.filter_weight),
      m_filter_order(options.filter_order),
      m_function(std::move(function))
{}

auto internal::Constrained_direction::operator()(const Mesh_view& mesh) -> Result
{
  const internal::Framed_surface& domain = m_transformation.domain();
  const Eigen::VectorXd raw = m_direction.rate(mesh, domain.surface(), domain.unit());
  require_one_per_vertex(raw);
  try {
    return constrained(raw);
  } catch (const Precondition_error& error) {
    throw Solver_error(error.function(), error.message());
  }
}

double internal::Constrained_direction::norm_on(const Mesh_view& next)
{
  const Normalized_frame frame(next.positions());
  Mesh_view framed = next;
  framed.set_positions(frame.to_frame(next.positions()));
  const Eigen::VectorXd raw = m_direction.rate(next, framed, frame.unit());
  require_one_per_vertex(raw);
  const internal::Constraint_basis basis = exactness().basis();
  return basis.norm(basis.project_out(filtered(raw))) * m_transformation.domain().unit();
}

Eigen::VectorXd internal::Constrained_direction::exact_part(const Eigen::VectorXd& rho)
{
  return rho.isZero(0) ? rho : exactness().basis().project_out(rho);
}

auto internal::Constrained_direction::constrained(const Eigen::VectorXd& raw) -> Result
{
  const auto& system = m_transformation.system();
  internal::Constraint_basis all = exactness().basis();
  if (m_volume) return at_volume(all, raw);
  if (system.is_closed())
    all.add(vertex_normals(system.surface(), internal::Normal_weight::angle).transpose());
  return measured(all, all.project_out(filtered(raw)), raw);
}

auto internal::Constrained_direction::at_volume(const Constraint_basis& others,
                                                const Eigen::VectorXd& raw) -> Result
{
  const double unit = m_transformation.domain().unit();
  Volume_constraint::Directions d =
      m_volume->directions(m_transformation, others, unit * filtered(raw));
  Result result = measured(others, d.kept / unit, raw);
  result.filling = d.filling / unit;
  result.factorizations = d.factorizations;
  result.solves = d.solves;
  return result;
}

auto internal::Constrained_direction::measured(const Constraint_basis& all, Eigen::VectorXd v,
                                               const Eigen::VectorXd& raw) const -> Result
{
  const double unit = m_transformation.domain().unit();
  Result result;
  result.filling = Eigen::VectorXd::Zero(v.size());
  result.v = std::move(v);
  result.norm = all.norm(result.v) * unit;
  result.share = all.norm(raw) > 0 ? all.norm(result.v) / all.norm(raw) : 0;
  return result;
}

const internal::Exactness_constraints& internal::Constrained_direction::exactness()
{
  return m_transformation.exactness(Curvature_potential::On::vertices);
}

// With mollification, the surface and its pattern change in every step.
Eigen::VectorXd internal::Constrained_direction::filtered(const Eigen::VectorXd& v)
{
  if (!(m_filter_weight > 0)) return v;
  const auto& system = m_transformation.system();
  if (m_filter && !m_transformation.domain().is_mollified())
    m_filter->update_geometry();
  else
    m_filter.emplace(system.surface(), m_filter_weight, m_filter_order,
                     system.matrix().shared_pattern(), system.solver());
  return (*m_filter)(v);
}

void internal::Constrained_direction::require_one_per_vertex(const Eigen::VectorXd& v) const
{
  if (v.size() != m_transformation.positions().cols())
    throw Precondition_error(m_function, "the direction has " + std::to_string(v.size()) +
                                             " values, one per vertex is needed: " +
                                             std::to_string(m_transformation.positions().cols()));
  internal::refuse_if_any(
      static_cast<int>(v.size()), [&](int i) { return !std::isfinite(v[i]); },
      [](int i) { return "vertex " + std::to_string(i); }, m_function,
      "#value of the direction not finite", "finite values are needed");
}

}  // namespace Conformal_geometry_processing
