// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

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
