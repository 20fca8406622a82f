// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PLACE_IN_PLANE_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PLACE_IN_PLANE_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// Converts points of the plane to points of space with z = 0, 3 x n
Points in_space(const Eigen::VectorXcd& z);

/// \ingroup PkgParameterization
/// \brief Applies the similarity to a map such that the sum of the areas of its faces is the area
/// of the surface, the mean of the loop is the origin, and the first vertex of the loop is on the
/// positive real axis. \param z |V| \param loop some vertices, at least one
Eigen::VectorXcd place_in_plane(const Mesh_view& mesh, Eigen::VectorXcd z,
                                const std::vector<int>& loop);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/parameterization/place_in_plane_impl.h>
#endif

#endif
