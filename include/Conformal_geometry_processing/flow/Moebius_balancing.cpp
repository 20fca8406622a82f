// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>

#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

internal::Moebius_balancing::Moebius_balancing(Eigen::VectorXd target_areas, std::string function)
    : m_target(std::move(target_areas)), m_function(std::move(function))
{
  for (Eigen::Index v = 0; v < m_target.size(); ++v)
    if (!(m_target[v] > 0) || !std::isfinite(m_target[v]))
      throw Precondition_error(m_function, "the target area of vertex " + std::to_string(v) +
                                               " is " + std::to_string(m_target[v]) +
                                               "; positive areas are needed");
}

Eigen::VectorXd internal::Moebius_balancing::log_length_scale(const Mesh_view& mesh) const
{
  return log_length_scale(areas_of(mesh));
}

double internal::Moebius_balancing::imbalance(const Mesh_view& mesh) const
{
  const Eigen::VectorXd areas = areas_of(mesh);
  return std::sqrt(areas.dot(log_length_scale(areas).cwiseAbs2()) / areas.sum());
}

// In units of the radius, as squares of squares of lengths may overflow.
Eigen::Vector3d internal::Moebius_balancing::step(const Mesh_view& mesh) const
{
  const Eigen::VectorXd areas = areas_of(mesh), shares = areas / areas.sum();
  Points f = mesh.positions().colwise() - centroid(mesh, areas);
  const double radius = f.colwise().norm().maxCoeff();
  f /= radius;
  const Eigen::Matrix3d inertia = f * shares.asDiagonal() * f.transpose();
  const Eigen::Vector3d moment = f * shares.cwiseProduct(log_length_scale(areas));
  const Eigen::Vector3d a = inertia.ldlt().solve(moment) / 2;
  const double nearness_of_pole = a.norm();
  return a / (radius * (std::max)(1., 2 * nearness_of_pole));
}

Eigen::VectorXd internal::Moebius_balancing::curvature_change(const Eigen::Vector3d& a,
                                                              const Points& normals)
{
  return -2 * normals.transpose() * a;
}

Points internal::Moebius_balancing::balanced(const Mesh_view& mesh) const
{
  const int most_halvings = 6;
  const double before = imbalance(mesh);
  Eigen::Vector3d a = step(mesh);
  Mesh_view image = mesh;
  for (int trial = 0; trial <= most_halvings && a != Eigen::Vector3d::Zero(); ++trial, a /= 2) {
    image.set_positions(inverted(mesh, a));
    if (imbalance(image) < before) return image.positions();
  }
  return mesh.positions();
}

Points internal::Moebius_balancing::inverted(const Mesh_view& mesh, const Eigen::Vector3d& a)
{
  const Eigen::VectorXd areas = vertex_areas(mesh);
  const Eigen::Vector3d center = centroid(mesh, areas);
  Mesh_view image = mesh;
  image.set_positions(
      Moebius_map::sphere_inversion(a).transform(mesh.positions().colwise() - center));
  const Eigen::VectorXd new_areas = vertex_areas(image);
  const Eigen::Vector3d new_center = centroid(image, new_areas);
  const double scale = std::sqrt(areas.sum() / new_areas.sum());
  return (scale * (image.positions().colwise() - new_center)).colwise() + center;
}

Eigen::VectorXd internal::Moebius_balancing::areas_of(const Mesh_view& mesh) const
{
  if (mesh.size_of_vertices() != m_target.size())
    throw Precondition_error(m_function, std::to_string(m_target.size()) +
                                             " target areas, one per vertex is needed: " +
                                             std::to_string(mesh.size_of_vertices()));
  return vertex_areas(mesh);
}

Eigen::VectorXd internal::Moebius_balancing::log_length_scale(const Eigen::VectorXd& areas) const
{
  const Eigen::VectorXd u = (areas.array() / m_target.array()).log() / 2;
  return u.array() - areas.dot(u) / areas.sum();
}

Eigen::Vector3d internal::Moebius_balancing::centroid(const Mesh_view& mesh,
                                                      const Eigen::VectorXd& areas)
{
  return mesh.positions() * (areas / areas.sum());
}

Eigen::VectorXd canonical_area_density(const Surface_ref& surface, const Eigen::MatrixXd& one_forms,
                                       const std::string& function)
{
  if (one_forms.cols() == 0)
    throw Precondition_error(function,
                             "the surface is a sphere, which has no canonical metric; "
                             "genus 1 or more is needed");
  Eigen::VectorXd u = Eigen::VectorXd::Zero(surface.size_of_sheets());
  for (const auto omega : one_forms.colwise())
    u += tangent_field(surface, omega).colwise().squaredNorm().transpose() / 2;
  return u;
}

Eigen::VectorXd canonical_vertex_areas(const Surface_ref& surface, const Eigen::VectorXd& density)
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(surface.size_of_vertices());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    for (const int v : sheet.corners) sum[v] += sheet.share * sheet.area * density[s] / 3;
  }
  return sum;
}

namespace internal {

Eigen::VectorXd target_areas(const Flow_options& options, Spin_transformation& transformation,
                             const std::string& function)
{
  if (options.balance == Flow_options::Balance::prescribed) return options.target_areas;
  const Surface_ref surface = transformation.system().surface();
  if (options.balance == Flow_options::Balance::initial) return vertex_areas(surface);
  const auto& exactness = transformation.exactness(Curvature_potential::On::vertices);
  const Eigen::MatrixXd forms = exactness.forms ? exactness.forms->one_forms() : Eigen::MatrixXd();
  return canonical_vertex_areas(surface, canonical_area_density(surface, forms, function));
}

}  // namespace internal

internal::Flow_balance::Flow_balance(const Mesh_view& mesh, const Flow_options& options,
                                     Spin_transformation& transformation,
                                     const std::string& function)
    : m_way(options.balancing)
{
  if (options.balance == Flow_options::Balance::none) return;
  require_closed(mesh, function);
  m_balancing.emplace(target_areas(options, transformation, function), function);
  (void)m_balancing->imbalance(mesh);  // throws if the number of areas is wrong
}

Eigen::VectorXd internal::Flow_balance::potential(const Mesh_view& mesh) const
{
  if (!m_balancing || m_way != Flow_options::Balancing::potential)
    return Eigen::VectorXd::Zero(mesh.size_of_vertices());
  return internal::Moebius_balancing::curvature_change(
      m_balancing->step(mesh), vertex_normals(mesh, internal::Normal_weight::angle));
}

Points internal::Flow_balance::inverted(Mesh_view mesh) const
{
  const int most_inversions = 8;
  const double worthwhile = 1e-3;  // share of the imbalance
  double before = m_balancing->imbalance(mesh), now = before;
  for (int i = 0; i < most_inversions; ++i, before = now) {
    mesh.set_positions(m_balancing->balanced(mesh));
    now = m_balancing->imbalance(mesh);
    if (now > (1 - worthwhile) * before) break;
  }
  return mesh.positions();
}

}  // namespace Conformal_geometry_processing
