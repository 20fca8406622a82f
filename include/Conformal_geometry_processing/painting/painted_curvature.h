// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/painting/image_filters.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgPainting
/// Returns, for each of |F| faces, the mean over its three corners of columns given at vertices:
/// centroids for positions, their texture coordinates for texture coordinates
template <int Rows>
Eigen::Matrix<double, Rows, Eigen::Dynamic> means_of_corners(
    const Mesh_view& mesh, const Eigen::Matrix<double, Rows, Eigen::Dynamic>& at_vertices)
{
  Eigen::Matrix<double, Rows, Eigen::Dynamic> means(at_vertices.rows(), mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    means.col(f) = (at_vertices.col(v[0]) + at_vertices.col(v[1]) + at_vertices.col(v[2])) / 3;
  }
  return means;
}

/// \ingroup PkgPainting
/// \brief Converts an image to rho [CGP 6.2]: amplitude (g - 1/2) on the faces, so that gray
/// changes nothing and bright areas bulge along the normals.
/// \param places (u, v) of the centre of each face in the image, 2 x |F|
/// \param amplitude in 1/length
Curvature_potential painted_curvature(const Gray_image& image, const Eigen::Matrix2Xd& places,
                                      double amplitude = 1);

}  // namespace Conformal_geometry_processing
