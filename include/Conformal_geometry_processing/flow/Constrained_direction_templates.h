// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CONSTRAINED_DIRECTION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CONSTRAINED_DIRECTION_TEMPLATES_H

#include <Conformal_geometry_processing/flow/Constrained_direction.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits, class Direction>
bool Constrained_direction<SolverTraits, EigensolverTraits, Direction>::Result::has_vanished(
    double tolerance) const
{
  const double norm_of_spheres = std::sqrt(4 * 3.14159265358979323846);
  return share <= tolerance || norm <= tolerance * norm_of_spheres;
}

template <class SolverTraits, class EigensolverTraits, class Direction>
Constrained_direction<SolverTraits, EigensolverTraits, Direction>::Constrained_direction(
    const Mesh_view& mesh, Direction direction, const Flow_options& options, Equation& equation,
    std::string function)
    : m_mesh(mesh),
      m_direction(std::move(direction)),
      m_closing(mesh, equation, options.exactness),
      m_is_closed(equation.is_closed()),
      m_function(std::move(function))
{
  if (options.filter_weight > 0)
    m_filter.emplace(mesh, options.filter_weight, options.filter_order,
                     equation.problem().matrix().shared_pattern(), equation.problem().solver());
}

template <class SolverTraits, class EigensolverTraits, class Direction>
auto Constrained_direction<SolverTraits, EigensolverTraits, Direction>::operator()(
    const Grounded_solver<SolverTraits>& laplacian) -> Result
{
  const Eigen::VectorXd raw = m_direction(m_mesh);
  require_one_per_vertex(raw);
  try {
    return constrained(raw, laplacian);
  } catch (const Precondition_error& error) {
    throw Solver_error(error.function(), error.message());
  }
}

template <class SolverTraits, class EigensolverTraits, class Direction>
Eigen::VectorXd Constrained_direction<SolverTraits, EigensolverTraits, Direction>::closing_part(
    const Eigen::VectorXd& rho) const
{
  return rho.isZero(0) ? rho : m_closing.basis().project_out(rho);
}

template <class SolverTraits, class EigensolverTraits, class Direction>
auto Constrained_direction<SolverTraits, EigensolverTraits, Direction>::constrained(
    const Eigen::VectorXd& raw, const Grounded_solver<SolverTraits>& laplacian) -> Result
{
  m_closing.update(laplacian);
  Constraint_basis all = m_closing.basis();
  if (m_is_closed) all.add(vertex_normals(m_mesh, Normal_weight::angle).transpose());
  Result result;
  result.v = all.project_out(filtered(raw));
  result.norm = all.norm(result.v);
  result.share = all.norm(raw) > 0 ? result.norm / all.norm(raw) : 0;
  return result;
}

template <class SolverTraits, class EigensolverTraits, class Direction>
Eigen::VectorXd Constrained_direction<SolverTraits, EigensolverTraits, Direction>::filtered(
    const Eigen::VectorXd& v)
{
  if (!m_filter) return v;
  m_filter->update_geometry();
  return (*m_filter)(v);
}

template <class SolverTraits, class EigensolverTraits, class Direction>
void Constrained_direction<SolverTraits, EigensolverTraits, Direction>::require_one_per_vertex(
    const Eigen::VectorXd& v) const
{
  if (v.size() != m_mesh.size_of_vertices())
    throw Precondition_error(m_function, "the direction has " + std::to_string(v.size()) +
                                             " values, one per vertex is needed: " +
                                             std::to_string(m_mesh.size_of_vertices()));
  internal::refuse_if_any(
      m_mesh.size_of_vertices(), [&](int i) { return !std::isfinite(v[i]); },
      [](int i) { return "vertex " + std::to_string(i); }, m_function,
      "#value of the direction not finite", "finite values are needed");
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Constrained_direction<Default_solver_traits, Lobpcg_eigensolver_traits,
                                            Willmore_direction>;

}  // namespace Conformal_geometry_processing
#endif

#endif
