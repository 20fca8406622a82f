// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_ROBUST_SPIN_TRANSFORMATION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_ROBUST_SPIN_TRANSFORMATION_TEMPLATES_H

#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Robust_spin_transformation.h>
#include <Conformal_geometry_processing/spin/certify.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits>
Robust_spin_transformation<SolverTraits, EigensolverTraits>::Robust_spin_transformation(
    const Mesh_view& mesh, double mollification, const std::string& function)
    : Robust_spin_transformation(mesh, Boundary_condition(), mollification, function)
{}

template <class SolverTraits, class EigensolverTraits>
Robust_spin_transformation<SolverTraits, EigensolverTraits>::Robust_spin_transformation(
    const Mesh_view& mesh, Boundary_condition condition, double mollification,
    const std::string& function, bool carries_generators)
    : m_function(function), m_mollification(mollification), m_condition(std::move(condition))
{
  require_manifold(mesh, function);
  require_some_area(mesh, function);
  if (!(mollification > 0 && mollification < 1))
    throw Precondition_error(function, "a mollification of " + std::to_string(mollification) +
                                           "; a number between 0 and 1 is needed");
  if (carries_generators) m_generators = closed_generators(mesh);
  m_state = std::make_unique<State>(mesh, *this);
}

template <class SolverTraits, class EigensolverTraits>
void Robust_spin_transformation<SolverTraits, EigensolverTraits>::set_positions(
    const Points& positions)
{
  if (positions.cols() != m_state->mesh.size_of_vertices())
    throw Precondition_error(m_function, "one position per vertex is needed");
  if (dirac_equation().positions())
    throw Precondition_error(m_function, "a surface with prescribed boundary cannot move");
  const Mesh_view moved(positions, m_state->mesh.corners());
  require_finite_positions(moved, m_function);
  require_some_area(moved, m_function);
  m_state = std::make_unique<State>(moved, *this);
}

template <class SolverTraits, class EigensolverTraits>
const Poisson_reconstruction<SolverTraits, Delaunay_view>&
Robust_spin_transformation<SolverTraits, EigensolverTraits>::reconstruction()
{
  const auto& problem = dirac_equation().problem();
  if (!m_state->poisson)
    m_state->poisson.emplace(view(), problem.matrix().shared_pattern(), problem.solver());
  return *m_state->poisson;
}

template <class SolverTraits, class EigensolverTraits>
void Robust_spin_transformation<SolverTraits, EigensolverTraits>::require_potential(
    const Curvature_potential& rho) const
{
  Conformal_geometry_processing::require_potential(m_state->mesh, rho, unit(), m_function);
}

template <class SolverTraits, class EigensolverTraits>
Spin_result Robust_spin_transformation<SolverTraits, EigensolverTraits>::transform(
    const Curvature_potential& rho, const Dirac_options& options, const Go_further& go_further) &
{
  Spin_result result = solve(rho, options, go_further);
  if (!result.report.cancelled) reconstruct(result);
  return result;
}

template <class SolverTraits, class EigensolverTraits>
Spin_result Robust_spin_transformation<SolverTraits, EigensolverTraits>::transform(
    const Curvature_potential& rho, const Dirac_options& options, const Go_further& go_further) &&
{
  Spin_result result = solve(rho, options, go_further);
  dirac_equation().release();
  if (!result.report.cancelled) reconstruct(result);
  return result;
}

template <class SolverTraits, class EigensolverTraits>
Robust_spin_transformation<SolverTraits, EigensolverTraits>::State::State(
    const Mesh_view& mesh_, const Robust_spin_transformation& of)
    : frame(mesh_.positions()),
      mesh(frame.to_frame(mesh_.positions()), mesh_.corners()),
      view(mesh, of.m_mollification, of.m_generators),
      measured(well_shaped_faces(mesh)),
      dirac(view, checked(of.in_frame(frame), view, of.m_function), of.m_function),
      seconds(watch.lap())
{}

template <class SolverTraits, class EigensolverTraits>
Boundary_condition Robust_spin_transformation<SolverTraits, EigensolverTraits>::checked(
    Boundary_condition condition, const Delaunay_view& view, const std::string& function)
{
  require_condition(view, condition, function);
  return condition;
}

template <class SolverTraits, class EigensolverTraits>
Boundary_condition Robust_spin_transformation<SolverTraits, EigensolverTraits>::in_frame(
    const Normalized_frame& frame) const
{
  Boundary_condition condition = m_condition;
  if (condition.kind == Boundary_condition::Kind::positions)
    condition.targets = frame.to_frame(std::move(condition.targets));
  return condition;
}

template <class SolverTraits, class EigensolverTraits>
Spin_report::Mollification
Robust_spin_transformation<SolverTraits, EigensolverTraits>::mollification() const
{
  const bool is_longer = view().added_length() > 0;
  return {m_mollification,
          view().number_of_thin_faces(),
          is_longer ? m_state->mesh.size_of_edges() : 0,
          view().added_length() * unit(),
          view().number_of_flips(),
          m_state->measured.mesh.size_of_faces(),
          m_state->measured.share};
}

template <class SolverTraits, class EigensolverTraits>
Spin_result Robust_spin_transformation<SolverTraits, EigensolverTraits>::solve(
    const Curvature_potential& rho, Dirac_options options, const Go_further& go_further)
{
  require_potential(rho);
  options.kernel_tolerance *= unit();
  Dirac_solution s = dirac_equation().solve({rho.on, rho.values * unit()}, options, go_further);
  Spin_result result;
  result.report = report_of(s, unit());
  result.report.seconds.setup = m_state->seconds;
  result.report.mollification = mollification();
  result.lambda = std::move(s.lambda);
  return result;
}

template <class SolverTraits, class EigensolverTraits>
void Robust_spin_transformation<SolverTraits, EigensolverTraits>::reconstruct(Spin_result& result)
{
  Stopwatch watch;
  State& now = *m_state;
  Spin_report& r = result.report;
  const Eigen::MatrixX3d edges = transformed_edges(now.view, result.lambda);
  Points f = now.dirac.positions() ? now.dirac.positions()->positions(edges)
                                   : reconstruction().positions(edges);
  r.closure_residual = reconstruction().residual(f, edges);
  r.seconds.reconstruction = watch.lap();
  // Not by the other faces: those of no area may have got wrinkled.
  if (!now.dirac.positions()) restore_area(now.measured.mesh, f, result.lambda);
  result.positions = now.frame.from_frame(f);
  f = now.frame.to_frame(result.positions);  // as they are rounded
  internal::certify(now.measured.mesh, f, result.lambda, r);
  const auto moved = [&] { return Delaunay_view({f, now.mesh.corners()}, m_mollification); };
  internal::judge_boundary(now.view, moved, f.allFinite(), now.dirac, unit(), r);
  r.seconds.certificate = watch.lap();
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Robust_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
