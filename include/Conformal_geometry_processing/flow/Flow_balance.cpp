// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Flow_balance.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

namespace Conformal_geometry_processing {
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
