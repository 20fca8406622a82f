// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {
namespace internal {

/// twice the vector area of each face
Points double_vector_areas(const Mesh_view& mesh, const Points& p)
{
  Points areas(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& [a, b, c] = mesh.corners(f);
    const Eigen::Vector3d ab = p.col(b) - p.col(a), ac = p.col(c) - p.col(a);
    areas.col(f) = ab.cross(ac);
  }
  return areas;
}

Target_mismatch::Target_mismatch(const Mesh_view& mesh, Points target, Eigen::VectorXd areas,
                                 double normal_weight, double tolerance)
    : m_target(std::move(target), mesh.corners()),
      m_frame(m_target.positions()),
      m_areas(std::move(areas)),
      m_normals(double_vector_areas(m_target, m_frame.to_frame(m_target.positions()))),
      m_normal_weight(normal_weight),
      m_tolerance(tolerance),
      m_source((*this)(mesh.positions()))
{
  const auto require = [](double x, const std::string& name) {
    if (!(x >= 0) || !std::isfinite(x))
      throw Precondition_error("Target_mismatch", name + " is " + std::to_string(x) +
                                                      ", it has to be finite and at least 0");
  };
  require(normal_weight, "the weight of normals");
  require(tolerance, "the tolerance of distances");
}

Target_mismatch::Value Target_mismatch::operator()(const Points& positions) const
{
  Value value{align(positions, m_target.positions(), m_areas)};
  const Points normals =
      double_vector_areas(m_target, m_frame.to_frame(value.alignment.apply(positions)));
  double squares = 0, area = 0;
  for (Eigen::Index f = 0; f < normals.cols(); ++f) {
    const double weight = m_normals.col(f).norm();
    area += weight;
    squares +=
        weight *
        (normals.col(f).stableNormalized() - m_normals.col(f).stableNormalized()).squaredNorm();
  }
  value.normals = area > 0 ? std::sqrt(squares / area) : 0;
  return value;
}

double Target_mismatch::sum(double d, double n) const
{
  const double least_distance = 1e-9, least_angle = 1e-3;
  d /= (std::max)(m_source.alignment.rms, least_distance);
  n /= (std::max)(m_source.normals, least_angle);
  return d * d + m_normal_weight * n * n;
}

bool Target_mismatch::is_reached(double d, double n) const
{
  const double turn = 100;
  return d <= m_tolerance && (m_normal_weight == 0 || n <= turn * m_tolerance);
}

}  // namespace internal

Nearest_spin_transformation::Nearest_spin_transformation(const Mesh_view& mesh, Points target,
                                                         const std::string& function,
                                                         const Nearest_spin_options& options)
    : Nearest_spin_transformation(function, mesh,
                                  internal::checked_target(mesh, std::move(target),
                                                           options.surface.mollification, function),
                                  options)
{
  const auto [before, after] = internal::in_frame(mesh, m_target);
  Quaternion_vector<double> faces = face_spins(before, after);
  if (options.surface.mollification) replace_thin_faces(before, after, faces);
  m_conflicts = make_consistent(before, faces);
  use(vertex_spins(before, faces));
}

Nearest_spin_transformation::Nearest_spin_transformation(const Mesh_view& mesh,
                                                         const Quaternion_vector<double>& mu,
                                                         const std::string& function,
                                                         const Nearest_spin_options& options)
    : Nearest_spin_transformation(mesh, integrated(mesh, mu, function, options), function, options)
{
  m_conflicts = 0;
  use(mu);
}

void Nearest_spin_transformation::scale_lengths(const Eigen::VectorXd& factor)
{
  const std::string function = "Nearest_spin_transformation::scale_lengths";
  m_visits.require_no_visit(function);
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
  m_options.keep_curvature = true;  // the target has other lengths
  use(std::move(scaled));
}

Nearest_spin_result Nearest_spin_transformation::transform(const internal::Go_further& go_further)
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  const auto is_done = [this](const Nearest_spin_result& r) {
    return m_options.keep_curvature || r.report.cancelled ||
           m_transformation->system().is_closed() || (r.report && r.distance <= r.source_distance);
  };
  const std::optional<Eigen::Vector3d> tangent({1, 0, 0}), binormal({0, 0, 1}), none;
  Nearest_spin_result found = transform_once(m_visits.guarded(go_further));
  for (const std::optional<Eigen::Vector3d>& direction : {binormal, tangent, none}) {
    if (is_done(found)) break;
    if (direction == m_options.direction) continue;
    use_boundary(direction);
    Nearest_spin_result next = transform_once(m_visits.guarded(go_further));
    add_costs(next.report, found.report);
    found = std::move(next);
  }
  return found;
}

Nearest_spin_result Nearest_spin_transformation::transform_once(
    const internal::Go_further& go_further)
{
  Spin_result guess = m_transformation->transform(m_rho, go_further);
  if (guess.report.cancelled) return placed(std::move(guess), m_rho);
  align_spins(guess.lambda);
  Nearest_spin_result start = placed(std::move(guess), m_rho);
  if (m_options.keep_curvature) return start;
  if (!m_transformation->system().directions()) {
    Nearest_spin_result same = unchanged();
    if (!start.report || !(start.distance < same.distance)) {
      add_costs(same.report, start.report);
      start = std::move(same);
    }
  }
  return searched(std::move(start), go_further);
}

Nearest_spin_result Nearest_spin_transformation::unchanged()
{
  const int n = m_transformation->domain().mesh().size_of_vertices();
  Spin_result same =
      m_transformation->integrate(Quaternion_vector<double>::Constant(n, {1, 0, 0, 0}));
  if (const auto& bound = m_options.surface.scales.bound) same.report.scales.bound = *bound;
  return placed(std::move(same), Curvature_potential::on_vertices(Eigen::VectorXd::Zero(n)));
}

Nearest_spin_result Nearest_spin_transformation::blend(const Nearest_spin_result& nearest, double t)
{
  m_visits.require_no_visit(m_function);
  Quaternion_vector<double> spins = nearest.lambda;
  align_spins(spins);
  for (Eigen::Index v = 0; v < spins.size(); ++v) spins[v] = spins[v] * (1 - t) + m_mu[v] * t;
  Spin_result between = m_transformation->integrate(std::move(spins));
  static_cast<internal::Dirac_evidence&>(between.report) = nearest.report;
  between.report.converged = nearest.report.converged && between.positions.allFinite();
  return placed(std::move(between), nearest.rho);
}

Nearest_spin_transformation::Nearest_spin_transformation(const std::string& function,
                                                         const Mesh_view& mesh, Points target,
                                                         const Nearest_spin_options& options)
    : m_function(function),
      m_options(options),
      m_target(std::move(target)),
      m_direction(options.direction),
      m_transformation(std::make_unique<Spin_transformation>(
          mesh, transformation_options(Mesh_view(m_target, mesh.corners()), options, m_direction),
          function)),
      m_mismatch(mesh, m_target, m_transformation->system().areas(), options.normal_weight,
                 options.distance_tolerance)
{}

void Nearest_spin_transformation::use_boundary(const std::optional<Eigen::Vector3d>& direction)
{
  m_direction = direction;
  const Mesh_view mesh(m_transformation->positions(), m_transformation->domain().mesh().corners());
  m_transformation = std::make_unique<Spin_transformation>(
      mesh, transformation_options(Mesh_view(m_target, mesh.corners()), m_options, direction),
      m_function);
}

void Nearest_spin_transformation::use(Quaternion_vector<double> mu)
{
  m_mu = std::move(mu);
  m_rho = curvature_of_spins(m_transformation->system().surface(), m_mu);
  m_rho.values /= m_transformation->domain().unit();
}

Points Nearest_spin_transformation::integrated(const Mesh_view& mesh,
                                               const Quaternion_vector<double>& mu,
                                               const std::string& function,
                                               const Nearest_spin_options& options)
{
  Spin_transformation_options own;
  own.mollification = options.surface.mollification;
  own.solvers = options.surface.solvers;
  Spin_transformation transformation(mesh, own, function);
  return transformation.integrate(mu).positions;
}

Spin_transformation_options Nearest_spin_transformation::transformation_options(
    const Mesh_view& target, const Nearest_spin_options& options,
    const std::optional<Eigen::Vector3d>& direction)
{
  Spin_transformation_options own = options.surface;
  own.boundary = {};
  if (!direction) return own;
  const internal::Boundary_frames frames =
      own.mollification ? boundary_frames(Delaunay_view(target, *own.mollification))
                        : boundary_frames(target);
  if (frames.vertices.empty()) return own;
  Points targets(3, static_cast<Eigen::Index>(frames.vertices.size()));
  for (std::size_t k = 0; k < frames.vertices.size(); ++k)
    targets.col(static_cast<Eigen::Index>(k)) = frames.frames[k] * *direction;
  own.boundary = Boundary_condition::directions(*direction, std::move(targets));
  return own;
}

void Nearest_spin_transformation::align_spins(Quaternion_vector<double>& lambda) const
{
  const auto& system = m_transformation->system();
  Quaternion<double> c = inner_product(lambda, system.areas(), m_mu) / system.squared_norm(lambda);
  if (system.directions()) c = {c.w, 0, 0, 0};
  for (Quaternion<double>& q : lambda) q = q * c;
}

Nearest_spin_result Nearest_spin_transformation::placed(Spin_result found,
                                                        Curvature_potential rho) const
{
  Nearest_spin_result result;
  static_cast<Spin_result&>(result) = std::move(found);
  result.rho = std::move(rho);
  if (m_transformation->system().directions()) result.direction = m_direction;
  if (!result.report.converged || result.report.cancelled) return result;
  const internal::Target_mismatch::Value here = m_mismatch(result.positions);
  result.positions = here.alignment.apply(result.positions);
  result.distance = here.alignment.rms;
  result.normal_distance = here.normals;
  result.source_distance = m_mismatch.source().alignment.rms;
  result.source_normal_distance = m_mismatch.source().normals;
  return result;
}

}  // namespace Conformal_geometry_processing
