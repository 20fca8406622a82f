// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_ENERGIES_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_ENERGIES_H

#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// the area of the surface
inline double total_area(const Mesh_view& mesh)
{
  return face_areas(mesh).sum();
}

/// \ingroup PkgMeasure
/// the volume enclosed by a closed surface, negative if its normals point inward
inline double signed_volume(const Mesh_view& mesh)
{
  // From a point of the surface, so that a far origin does not cost digits.
  const Eigen::Vector3d o = mesh.position(0);
  double volume = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    volume += mesh.double_area_vector(f).dot(mesh.position(mesh.corners(f)[0]) - o) / 6;
  return volume;
}

/// \ingroup PkgMeasure
/// the signed dihedral angle between the two faces at each edge, positive where convex, zero at the
/// boundary; |E| numbers in (-pi, pi]
inline Eigen::VectorXd bending_angles(const Mesh_view& mesh)
{
  const Points N = face_normals(mesh);
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const int h = mesh.halfedges_begin(k)[0], g = mesh.twin(h);
    if (g < 0) continue;
    const Eigen::Vector3d left = N.col(Mesh_view::face(h)), right = N.col(Mesh_view::face(g));
    // From the left face to the right one the normal of a convex edge turns by a positive angle
    // about the edge's direction.
    angles[k] =
        std::atan2(left.cross(right).dot(stable_normalized(mesh.vector(h))), left.dot(right));
  }
  return angles;
}

/// \ingroup PkgMeasure
/// \brief the Willmore energy, the integral of H^2, as sum V_i H_i^2 with cotan curvatures and
/// mixed Voronoi areas [CGP 6.4]; 4 pi for round spheres, and not changed by scaling.
///
/// The sum can be *below* 4 pi by O(h^2), though no smooth closed surface is.
inline double willmore_energy(const Mesh_view& mesh)
{
  return voronoi_areas(mesh).dot(mean_curvature(mesh).cwiseAbs2());
}

/// \ingroup PkgMeasure
/// the same with H_i V_i = 1/4 sum of bending angle times length over the edges at i, from
/// Steiner's formula, and barycentric areas V_i; knows nothing of cotangents and errs to the other
/// side
inline double steiner_willmore_energy(const Mesh_view& mesh)
{
  const Eigen::VectorXd angles = bending_angles(mesh), areas = vertex_areas(mesh);
  Eigen::VectorXd integral = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (int v : mesh.ends(k))
      integral[v] += angles[k] * mesh.vector(mesh.halfedges_begin(k)[0]).norm() / 4;
  return integral.cwiseAbs2().cwiseQuotient(areas).sum();
}

}  // namespace Conformal_geometry_processing

#endif
