// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_BOUNDARY_CONDITION_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_BOUNDARY_CONDITION_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <Eigen/Core>

#include <utility>

namespace Conformal_geometry_processing {

CGP_INLINE Boundary_condition Boundary_condition::tangents(Points targets)
{
  return directions({1, 0, 0}, std::move(targets));
}

CGP_INLINE Boundary_condition Boundary_condition::binormals(Points targets)
{
  return directions({0, 0, 1}, std::move(targets));
}

CGP_INLINE Boundary_condition Boundary_condition::directions(const Eigen::Vector3d& direction,
                                                             Points targets)
{
  return {Kind::directions, direction, std::move(targets), Points(3, 0)};
}

CGP_INLINE Boundary_condition Boundary_condition::positions(Points targets, Points normals,
                                                            double weight)
{
  return {Kind::positions, {1, 0, 0}, std::move(targets), std::move(normals), weight};
}

}  // namespace Conformal_geometry_processing

#endif
