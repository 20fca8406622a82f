// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_TRANSFORMATION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_TRANSFORMATION_TEMPLATES_H

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/certify.h>
#include <Conformal_geometry_processing/spin/report_of_solution.h>
#include <Conformal_geometry_processing/spin/restore_area.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <string>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits>
Spin_transformation<SolverTraits, EigensolverTraits>::Spin_transformation(
    const Mesh_view& mesh, const std::string& function)
    : Spin_transformation(mesh, Boundary_condition(), function)
{}

template <class SolverTraits, class EigensolverTraits>
Spin_transformation<SolverTraits, EigensolverTraits>::Spin_transformation(
    const Mesh_view& mesh, const Boundary_condition& condition, const std::string& function)
    : m_function(function),
      m_frame(checked(mesh, condition, function).positions()),
      m_mesh(mesh),
      m_dirac(in_frame(m_mesh, m_frame), in_frame(condition), function),
      m_setup_seconds(m_watch.lap())
{}

template <class SolverTraits, class EigensolverTraits>
void Spin_transformation<SolverTraits, EigensolverTraits>::set_positions(const Points& positions)
{
  require_size(positions.cols(), "positions");
  if (m_dirac.positions())
    throw Precondition_error(m_function, "a surface with prescribed boundary cannot move");
  const Points before = m_mesh.positions();
  m_mesh.set_positions(positions);
  try {
    require_finite_positions(m_mesh, m_function);
    require_positive_areas(m_mesh, m_function);
  } catch (...) {
    m_mesh.set_positions(before);
    throw;
  }
  m_frame = Normalized_frame(positions);
  in_frame(m_mesh, m_frame);
  m_dirac.update_geometry();
  m_has_moved = true;
}

template <class SolverTraits, class EigensolverTraits>
const Poisson_reconstruction<SolverTraits>&
Spin_transformation<SolverTraits, EigensolverTraits>::reconstruction()
{
  const auto& dirac = m_dirac.problem();
  if (!m_reconstruction)
    m_reconstruction.emplace(m_mesh, dirac.matrix().shared_pattern(), dirac.solver());
  else if (m_has_moved)
    m_reconstruction->update_geometry();
  m_has_moved = false;
  return *m_reconstruction;
}

template <class SolverTraits, class EigensolverTraits>
void Spin_transformation<SolverTraits, EigensolverTraits>::require_potential(
    const Curvature_potential& rho) const
{
  Conformal_geometry_processing::require_potential(m_mesh, rho, m_frame.unit(), m_function);
}

template <class SolverTraits, class EigensolverTraits>
Spin_result Spin_transformation<SolverTraits, EigensolverTraits>::transform(
    const Curvature_potential& rho, const Dirac_options& options, const Go_further& go_further) &
{
  Spin_result result = solve(rho, options, go_further);
  if (!result.report.cancelled) reconstruct(result);
  return result;
}

template <class SolverTraits, class EigensolverTraits>
Spin_result Spin_transformation<SolverTraits, EigensolverTraits>::transform(
    const Curvature_potential& rho, const Dirac_options& options, const Go_further& go_further) &&
{
  Spin_result result = solve(rho, options, go_further);
  m_dirac.release();
  if (!result.report.cancelled) reconstruct(result);
  return result;
}

template <class SolverTraits, class EigensolverTraits>
Spin_result Spin_transformation<SolverTraits, EigensolverTraits>::integrate(
    Quaternion_vector<double> lambda)
{
  require_size(lambda.size(), "spins");
  Spin_result result;
  result.lambda = std::move(lambda);
  result.report.converged = true;
  reconstruct(result);
  return result;
}

template <class SolverTraits, class EigensolverTraits>
const Mesh_view& Spin_transformation<SolverTraits, EigensolverTraits>::checked(
    const Mesh_view& mesh, const Boundary_condition& condition, const std::string& function)
{
  require_surface(mesh, function);
  require_condition(mesh, condition, function);
  return mesh;
}

template <class SolverTraits, class EigensolverTraits>
Boundary_condition Spin_transformation<SolverTraits, EigensolverTraits>::in_frame(
    Boundary_condition condition) const
{
  if (condition.kind == Boundary_condition::Kind::positions)
    condition.targets = m_frame.to_frame(std::move(condition.targets));
  return condition;
}

template <class SolverTraits, class EigensolverTraits>
const Mesh_view& Spin_transformation<SolverTraits, EigensolverTraits>::in_frame(
    Mesh_view& mesh, const Normalized_frame& frame)
{
  mesh.set_positions(frame.to_frame(mesh.positions()));
  return mesh;
}

template <class SolverTraits, class EigensolverTraits>
void Spin_transformation<SolverTraits, EigensolverTraits>::require_size(
    Eigen::Index size, const std::string& what) const
{
  if (size != m_mesh.size_of_vertices())
    throw Precondition_error(
        m_function, std::to_string(size) + " " + what +
                        ", one per vertex is needed: " + std::to_string(m_mesh.size_of_vertices()));
}

template <class SolverTraits, class EigensolverTraits>
Spin_result Spin_transformation<SolverTraits, EigensolverTraits>::solve(
    const Curvature_potential& rho, Dirac_options options, const Go_further& go_further)
{
  require_potential(rho);
  options.kernel_tolerance *= m_frame.unit();
  const Curvature_potential rho_in_frame{rho.on, rho.values * m_frame.unit()};
  Dirac_solution s = m_dirac.solve(rho_in_frame, options, go_further);
  Spin_result result;
  result.report = report_of(s, m_frame.unit());
  result.report.seconds.setup = m_setup_seconds;
  result.lambda = std::move(s.lambda);
  return result;
}

template <class SolverTraits, class EigensolverTraits>
void Spin_transformation<SolverTraits, EigensolverTraits>::reconstruct(Spin_result& result)
{
  Stopwatch watch;
  Spin_report& r = result.report;
  const Eigen::MatrixX3d edges = transformed_edges(m_mesh, result.lambda);
  Points f = m_dirac.positions() ? m_dirac.positions()->positions(edges)
                                 : reconstruction().positions(edges);
  r.closure_residual = reconstruction().residual(f, edges);
  r.seconds.reconstruction = watch.lap();
  if (!m_dirac.positions()) restore_area(m_mesh, f, result.lambda);
  result.positions = m_frame.from_frame(f);
  f = m_frame.to_frame(result.positions);  // as they are rounded
  internal::certify(m_mesh, f, result.lambda, r);
  const auto moved = [&] { return Mesh_view(f, m_mesh.corners()); };
  internal::judge_boundary(m_mesh, moved, f.allFinite(), m_dirac, m_frame.unit(), r);
  r.seconds.certificate = watch.lap();
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
