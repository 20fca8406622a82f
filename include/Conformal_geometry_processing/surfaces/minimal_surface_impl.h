// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_MINIMAL_SURFACE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_MINIMAL_SURFACE_IMPL_H

#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/boundary_fault.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

CGP_INLINE double minimal_kernel_tolerance(const Mesh_view& mesh)
{
  const double pi = std::acos(-1.);
  return boundary_loops(mesh).size() > 1 ? 3 * mean_edge_length(mesh) * pi / face_areas(mesh).sum()
                                         : 0;
}

CGP_INLINE void internal::judge_minimality(const Mesh_view& mesh,
                                           const Boundary_condition& condition, Spin_report& report)
{
  if (condition.is_self_adjoint() && std::abs(report.eigenvalue) > greatest_zero(mesh))
    report.boundary_fault = Spin_report::Boundary_fault::not_realizable;
}

CGP_INLINE Boundary_condition internal::part_of_turn(const Mesh_view& mesh,
                                                     Boundary_condition condition, double share)
{
  if (condition.targets.cols() == 0) return condition;
  const Boundary_frames b = boundary_frames(mesh);
  for (std::size_t k = 0; k < b.frames.size(); ++k) {
    auto target = condition.targets.col(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d present = b.frames[k] * stable_normalized(condition.direction);
    const Quaternion<double> q = rotor<double>(present, stable_normalized(target));
    const Eigen::Quaterniond turn(q.w, -q.x, -q.y, -q.z);  // v -> turn v conjugate(turn)
    target = Eigen::Quaterniond::Identity().slerp(share, turn) * present;
  }
  return condition;
}

}  // namespace Conformal_geometry_processing

#endif
