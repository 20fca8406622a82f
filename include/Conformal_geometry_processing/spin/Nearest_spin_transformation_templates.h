// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_NEAREST_SPIN_TRANSFORMATION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_NEAREST_SPIN_TRANSFORMATION_TEMPLATES_H

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/Spin_transformation_templates.h>
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
    const Nearest_spin_options& options)
    : Nearest_spin_transformation(function, mesh,
                                  checked(mesh, std::move(target), function, options), options)
{
  const auto [before, after] = in_frame(mesh, m_target);
  Quaternion_vector<double> faces = face_spins(before, after);
  if (options.mollification) replace_thin_faces(before, after, faces);
  m_conflicts = make_consistent(before, faces);
  use(vertex_spins(before, faces));
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_transformation<SolverTraits, EigensolverTraits>::Nearest_spin_transformation(
    const Mesh_view& mesh, const Quaternion_vector<double>& mu, const std::string& function,
    const Nearest_spin_options& options)
    : Nearest_spin_transformation(mesh, integrated(mesh, mu, function, options), function, options)
{
  m_conflicts = 0;
  use(mu);
}

template <class SolverTraits, class EigensolverTraits>
void Nearest_spin_transformation<SolverTraits, EigensolverTraits>::scale_lengths(
    const Eigen::VectorXd& factor)
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
  use(std::move(scaled));
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_result Nearest_spin_transformation<SolverTraits, EigensolverTraits>::transform(
    const Dirac_options& options, const internal::Go_further& go_further)
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
  static_cast<internal::Dirac_evidence&>(between.report) = nearest.report;
  between.report.converged = nearest.report.converged && between.positions.allFinite();
  return placed(std::move(between));
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_transformation<SolverTraits, EigensolverTraits>::Nearest_spin_transformation(
    const std::string& function, const Mesh_view& mesh, Points target,
    const Nearest_spin_options& options)
    : m_target(std::move(target)),
      m_transformation(mesh, transformation_options(Mesh_view(m_target, mesh.corners()), options),
                       function)
{}

template <class SolverTraits, class EigensolverTraits>
void Nearest_spin_transformation<SolverTraits, EigensolverTraits>::use(Quaternion_vector<double> mu)
{
  m_mu = std::move(mu);
  m_rho = curvature_of_spins(m_transformation.system().surface(), m_mu);
  m_rho.values /= m_transformation.domain().unit();
}

template <class SolverTraits, class EigensolverTraits>
Points Nearest_spin_transformation<SolverTraits, EigensolverTraits>::integrated(
    const Mesh_view& mesh, const Quaternion_vector<double>& mu, const std::string& function,
    const Nearest_spin_options& options)
{
  Spin_transformation_options own;
  own.mollification = options.mollification;
  return Spin_transformation<SolverTraits, EigensolverTraits>(mesh, own, function)
      .integrate(mu)
      .positions;
}

template <class SolverTraits, class EigensolverTraits>
Points Nearest_spin_transformation<SolverTraits, EigensolverTraits>::checked(
    const Mesh_view& mesh, Points target, const std::string& function,
    const Nearest_spin_options& options)
{
  internal::Framed_surface::require(mesh, options.mollification, function);
  if (target.cols() != mesh.size_of_vertices())
    throw Precondition_error(function, std::to_string(target.cols()) +
                                           " target positions, one per vertex is needed: " +
                                           std::to_string(mesh.size_of_vertices()));
  internal::Framed_surface::require_faces(Mesh_view(target, mesh.corners()),
                                          options.mollification.has_value(), function + ", target");
  const auto [before, after] = in_frame(mesh, target);
  if (boundary_loops(mesh).empty() && !options.mollification)
    require_same_spin_structure(before, after, function);
  return target;
}

template <class SolverTraits, class EigensolverTraits>
std::pair<Mesh_view, Points> Nearest_spin_transformation<SolverTraits, EigensolverTraits>::in_frame(
    const Mesh_view& mesh, const Points& target)
{
  const internal::Normalized_frame frame(mesh.positions());
  std::pair<Mesh_view, Points> both{mesh, frame.to_frame(target)};
  both.first.set_positions(frame.to_frame(mesh.positions()));
  return both;
}

template <class SolverTraits, class EigensolverTraits>
Spin_transformation_options
Nearest_spin_transformation<SolverTraits, EigensolverTraits>::transformation_options(
    const Mesh_view& target, const Nearest_spin_options& options)
{
  Spin_transformation_options own;
  own.exactness = options.exactness;
  own.max_period_defect = options.max_period_defect;
  own.mollification = options.mollification;
  const internal::Boundary_frames frames =
      options.mollification ? boundary_frames(Delaunay_view(target, *options.mollification))
                            : boundary_frames(target);
  if (frames.vertices.empty()) return own;
  Points targets(3, static_cast<Eigen::Index>(frames.vertices.size()));
  for (std::size_t k = 0; k < frames.vertices.size(); ++k)
    targets.col(static_cast<Eigen::Index>(k)) = frames.frames[k] * options.direction;
  own.boundary = Boundary_condition::directions(options.direction, std::move(targets));
  return own;
}

template <class SolverTraits, class EigensolverTraits>
void Nearest_spin_transformation<SolverTraits, EigensolverTraits>::align_spins(
    Quaternion_vector<double>& lambda) const
{
  const auto& system = m_transformation.system();
  Quaternion<double> c = inner_product(lambda, system.areas(), m_mu) / system.squared_norm(lambda);
  if (!system.is_closed()) c = {c.w, 0, 0, 0};
  for (Quaternion<double>& q : lambda) q = q * c;
}

template <class SolverTraits, class EigensolverTraits>
Nearest_spin_result Nearest_spin_transformation<SolverTraits, EigensolverTraits>::placed(
    Spin_result found) const
{
  Nearest_spin_result result{std::move(found), 0};
  if (!result.report.converged) return result;
  const internal::Alignment a = align(result.positions, m_target);
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
