// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// Returns the area of the surface
double total_area(const Mesh_view& mesh);

/// \ingroup PkgMeasure
/// Returns the volume enclosed by a closed surface, negative if its normals point inward
double signed_volume(const Mesh_view& mesh);

/// \ingroup PkgMeasure
/// Returns the signed dihedral angle between the two faces at each edge, positive if convex, zero
/// at the boundary; |E| numbers in (-pi, pi]
Eigen::VectorXd bending_angles(const Mesh_view& mesh);

/// \ingroup PkgMeasure
/// \brief Returns the Willmore energy, the integral of H^2, as sum V_i H_i^2 with cotan curvatures
/// and mixed Voronoi areas [CGP 6.4]; 4 pi for round spheres, and scale-invariant.
///
/// The sum can be *below* 4 pi by O(h^2), unlike the energy of smooth closed surfaces.
double willmore_energy(const Surface_ref& surface);

/// \ingroup PkgMeasure
/// Returns the Willmore energy with H_i V_i = 1/4 sum of bending angle times length over the edges
/// at i, from Steiner's formula, and barycentric areas V_i; independent of cotangents, with an
/// error of the opposite sign
double steiner_willmore_energy(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
