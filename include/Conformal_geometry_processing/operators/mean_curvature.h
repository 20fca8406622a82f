// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// Sets each unknown value to the mean of the known neighbours, ring by ring; leaves the values
/// unchanged if nothing is known.
void fill_unknown(const Surface_ref& surface, std::vector<char> is_unknown,
                  Eigen::VectorXd& values);

/// \brief The angle defects K of the vertices: 2 pi minus the sum of the angles, pi at the
/// boundary, |V|. They sum to 2 pi chi.
Eigen::VectorXd angle_defects(const Mesh_view& mesh);

}  // namespace internal

/// \ingroup PkgOperators
/// \brief H at the vertices, |V| numbers in 1/length: +1 on the unit sphere with outward normals.
///
/// H_i = <N_i, (L f)_i> / (2 V_i), from Delta f = 2 H N, with mixed Voronoi areas V_i and
/// angle-weighted normals. At boundary vertices L f also contains the curvature of the boundary
/// curve, and at vertices whose area is less than a thousandth of a neighbour's, rounding
/// dominates: there H is the mean of the other neighbours.
///
/// Under refinement, single values converge on regular meshes only. On irregular ones their errors
/// keep their size, for L f sees the place of each neighbour; only averages converge, as the
/// integral of H against a smooth function does, with O(h^2).
Eigen::VectorXd mean_curvature(const Surface_ref& surface);

/// \ingroup PkgOperators
/// \brief H |df|, the mean curvature half-density: H times the square root of the area, |V|
/// dimensionless numbers [CGP 4.4]. Spin transformations add rho |df| to it [CGP (4.6)].
Eigen::VectorXd mean_curvature_half_density(const Surface_ref& surface);

}  // namespace Conformal_geometry_processing
