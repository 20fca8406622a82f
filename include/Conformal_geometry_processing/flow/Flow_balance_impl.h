// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_FLOW_BALANCE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_FLOW_BALANCE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/flow/Flow_balance.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::VectorXd internal::Flow_balance::potential(const Mesh_view& mesh) const
{
  if (!m_balancing || m_way != Flow_options::Balancing::potential)
    return Eigen::VectorXd::Zero(mesh.size_of_vertices());
  return internal::Moebius_balancing::curvature_change(
      m_balancing->step(mesh), vertex_normals(mesh, internal::Normal_weight::angle));
}

CGP_INLINE Points internal::Flow_balance::inverted(Mesh_view mesh) const
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

#endif
