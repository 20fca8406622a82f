// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CURVATURE_POTENTIAL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CURVATURE_POTENTIAL_H

#include <Conformal_geometry_processing/algebra/Quaternionic_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief rho: the change of mean curvature that a spin transformation brings about, in 1/length,
/// with one value per vertex or one per face.
///
/// H~ |lambda|^2 = H + rho + gamma: positive rho bulges outward [CGP (4.6)].
struct Curvature_potential {
  enum class On { vertices, faces };

  On on;
  Eigen::VectorXd values;  ///< |V| or |F|

  static Curvature_potential on_vertices(Eigen::VectorXd rho)
  {
    return {On::vertices, std::move(rho)};
  }
  static Curvature_potential on_faces(Eigen::VectorXd rho) { return {On::faces, std::move(rho)}; }

  /// its values at the three corners of face f
  Eigen::Vector3d at_corners(const Mesh_view& mesh, int f) const
  {
    if (on == On::faces) return Eigen::Vector3d::Constant(values[f]);
    const std::array<int, 3>& v = mesh.corners(f);
    return {values[v[0]], values[v[1]], values[v[2]]};
  }
};

/// \ingroup PkgOperators
/// rho = 0, on the vertices
inline Curvature_potential no_potential(const Mesh_view& mesh)
{
  return Curvature_potential::on_vertices(Eigen::VectorXd::Zero(mesh.size_of_vertices()));
}

/// \ingroup PkgOperators
/// \brief R: |F| x |V|, multiplication by rho [CGP 5.3]; in 1/length.
///
/// R = P B for rho on faces and R = B P for rho on vertices, with P = diag(rho): the latter
/// interpolates the product rho lambda linearly.
/// \param mesh must outlive the matrix
inline Quaternionic_sparse_matrix<double> potential_matrix(const Mesh_view& mesh,
                                                           const Curvature_potential& rho)
{
  Quaternionic_sparse_matrix<double> R(mesh.corners(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const Eigen::Vector3d r = rho.at_corners(mesh, f);
    for (int c = 0; c < 3; ++c) R.value(f, c) = {r[c] / 3, 0, 0, 0};
  }
  return R;
}

/// \ingroup PkgOperators
/// the mean of rho over the surface, weighted by area
inline double mean(const Mesh_view& mesh, const Curvature_potential& rho)
{
  const Eigen::VectorXd areas =
      rho.on == Curvature_potential::On::faces ? face_areas(mesh) : vertex_areas(mesh);
  return areas.dot(rho.values) / areas.sum();
}

}  // namespace Conformal_geometry_processing

#endif
