// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_NEAREST_SPIN_TRANSFORMATION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_NEAREST_SPIN_TRANSFORMATION_TEMPLATES_H

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_of_spins.h>
#include <Conformal_geometry_processing/spin/face_spins.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_transformation<SolverTraits, EigensolverTraits>::Nearest_spin_transformation(
    const Mesh_view& mesh, Points target, const std::string& function,
    const Eigen::Vector3d& direction)
    : Nearest_spin_transformation(function, mesh, checked(mesh, std::move(target), function),
                                  direction)
{
  Quaternion_vector<double> faces = face_spins(mesh, m_target);
  m_conflicts = make_consistent(mesh, faces);
  use(mesh, vertex_spins(mesh, faces));
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_transformation<SolverTraits, EigensolverTraits>::Nearest_spin_transformation(
    const Mesh_view& mesh, const Quaternion_vector<double>& mu, const std::string& function)
    : Nearest_spin_transformation(mesh, integrated(mesh, mu, function), function)
{
  m_conflicts = 0;
  use(mesh, mu);
}

template <class SolverTraits, class EigensolverTraits>
void Nearest_spin_transformation<SolverTraits, EigensolverTraits>::scale_lengths(
    const Mesh_view& mesh, const Eigen::VectorXd& factor)
{
  const std::string function = "Nearest_spin_transformation::scale_lengths";
  if (factor.size() != m_mu.size())
    throw Precondition_error(
        function, std::to_string(factor.size()) +
                      " factors, one per vertex is needed: " + std::to_string(m_mu.size()));
  internal::refuse_if_any(
      static_cast<int>(factor.size()),
      [&](int v) { return !(factor[v] > 0) || !std::isfinite(factor[v]); },
      internal::name_of_vertex, function, "#factor not positive", "positive ones are needed");
  Quaternion_vector<double> scaled = m_mu;
  for (Eigen::Index v = 0; v < scaled.size(); ++v) scaled[v] *= std::sqrt(factor[v]);
  use(mesh, std::move(scaled));
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_result Nearest_spin_transformation<SolverTraits, EigensolverTraits>::transform(
    const Dirac_options& options, const Go_further& go_further)
{
  Spin_result found = m_transformation.transform(m_rho, options, go_further);
  if (found.report.cancelled) return {std::move(found), 0};
  align_spins(found.lambda);
  return placed(std::move(found));
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_result Nearest_spin_transformation<SolverTraits, EigensolverTraits>::blend(
    const Nearest_spin_result& nearest, double t)
{
  Quaternion_vector<double> spins = nearest.lambda;
  align_spins(spins);
  for (Eigen::Index v = 0; v < spins.size(); ++v) spins[v] = spins[v] * (1 - t) + m_mu[v] * t;
  Spin_result between = m_transformation.integrate(std::move(spins));
  tell_equation(nearest.report, between.report);
  return placed(std::move(between));
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_transformation<SolverTraits, EigensolverTraits>::Nearest_spin_transformation(
    const std::string& function, const Mesh_view& mesh, Points target,
    const Eigen::Vector3d& direction)
    : m_target(std::move(target)),
      m_transformation(mesh, boundary_condition(mesh, m_target, direction), function),
      m_areas(vertex_areas(mesh)),
      m_is_closed(m_transformation.dirac_equation().is_closed())
{}

template <class SolverTraits, class EigensolverTraits>
void Nearest_spin_transformation<SolverTraits, EigensolverTraits>::use(const Mesh_view& mesh,
                                                                       Quaternion_vector<double> mu)
{
  m_mu = std::move(mu);
  m_rho = curvature_of_spins(mesh, m_mu);
}

template <class SolverTraits, class EigensolverTraits>
Points Nearest_spin_transformation<SolverTraits, EigensolverTraits>::integrated(
    const Mesh_view& mesh, const Quaternion_vector<double>& mu, const std::string& function)
{
  return Spin_transformation<SolverTraits, EigensolverTraits>(mesh, function)
      .integrate(mu)
      .positions;
}

template <class SolverTraits, class EigensolverTraits>
Points Nearest_spin_transformation<SolverTraits, EigensolverTraits>::checked(
    const Mesh_view& mesh, Points target, const std::string& function)
{
  require_surface(mesh, function);
  if (target.cols() != mesh.size_of_vertices())
    throw Precondition_error(function, std::to_string(target.cols()) +
                                           " target positions, one per vertex is needed: " +
                                           std::to_string(mesh.size_of_vertices()));
  const Mesh_view deformed(target, mesh.corners());
  require_finite_positions(deformed, function + ", target");
  require_positive_areas(deformed, function + ", target");
  if (boundary_loops(mesh).empty()) require_same_spin_structure(mesh, target, function);
  return target;
}

template <class SolverTraits, class EigensolverTraits>
Boundary_condition Nearest_spin_transformation<SolverTraits, EigensolverTraits>::boundary_condition(
    const Mesh_view& mesh, const Points& target, const Eigen::Vector3d& direction)
{
  const Boundary_frames frames = boundary_frames({target, mesh.corners()});
  if (frames.vertices.empty()) return Boundary_condition::free();
  Points targets(3, static_cast<Eigen::Index>(frames.vertices.size()));
  for (std::size_t k = 0; k < frames.vertices.size(); ++k)
    targets.col(static_cast<Eigen::Index>(k)) = frames.frames[k] * direction;
  return Boundary_condition::directions(direction, std::move(targets));
}

template <class SolverTraits, class EigensolverTraits>
void Nearest_spin_transformation<SolverTraits, EigensolverTraits>::tell_equation(
    const Spin_report& from, Spin_report& to)
{
  to.eigenvalue = from.eigenvalue;
  to.residual = from.residual;
  to.gap = from.gap;
  to.overlap = from.overlap;
  to.iterations = from.iterations;
  to.substeps = from.substeps;
  to.spectral_shift = from.spectral_shift;
}

template <class SolverTraits, class EigensolverTraits>
void Nearest_spin_transformation<SolverTraits, EigensolverTraits>::align_spins(
    Quaternion_vector<double>& lambda) const
{
  Quaternion<double> c =
      inner_product(lambda, m_areas, m_mu) / inner_product(lambda, m_areas, lambda).w;
  if (!m_is_closed) c = {c.w, 0, 0, 0};
  for (Quaternion<double>& q : lambda) q = q * c;
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_result Nearest_spin_transformation<SolverTraits, EigensolverTraits>::placed(
    Spin_result found) const
{
  Nearest_spin_result result{std::move(found), 0};
  if (!result.report.converged) return result;
  const Alignment a = align(result.positions, m_target);
  result.positions = a.apply(result.positions);
  result.distance = a.rms;
  return result;
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Nearest_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
