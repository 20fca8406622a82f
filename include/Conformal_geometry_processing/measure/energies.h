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

/// \ingroup PkgMeasure
/// the area of a closed surface and the volume that it encloses
struct Enclosure {
  double area = 0;
  double volume = 0;          ///< negative if the normals point inward
  double reduced_volume = 0;  ///< the volume by that of the round sphere of the same area, at most
                              ///< 1: 6 sqrt(pi) volume / area^(3/2), which is scale-invariant
};

/// \ingroup PkgMeasure
/// Returns area and volume of a closed surface of any scale
Enclosure enclosure(const Mesh_view& mesh);

namespace internal {

/// \brief area, enclosed volume, and their derivatives by the positions, which are bounded for thin
/// faces too. Faces without area have no derivative and count as zero there.
struct Enclosure_gradient {
  /// \param f positions of the vertices, 3 x |V|, of a scale where volumes do not overflow
  Enclosure_gradient(const Mesh_view& mesh, const Points& f);

  double reduced_volume() const;

  /// of its logarithm, 3 x |V|
  Points of_log_reduced_volume() const;

  double area = 0, volume = 0;
  Points of_area, of_volume;  ///< 3 x |V|
};

}  // namespace internal

}  // namespace Conformal_geometry_processing
