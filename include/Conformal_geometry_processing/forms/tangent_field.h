// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_TANGENT_FIELD_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_TANGENT_FIELD_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// the integral of a 1-form along halfedge h
/// \param omega |E| numbers, along each edge i -> j, i < j
template <class Derived>
double along_halfedge(const Mesh_view& mesh, const Eigen::MatrixBase<Derived>& omega, int h)
{
  return mesh.from(h) < mesh.to(h) ? omega[mesh.edge(h)] : -omega[mesh.edge(h)];
}

/// \ingroup PkgForms
/// \brief the tangent vector v of each face with <v, e> = omega(e) along its edges, 3 x |F|
/// [CGP 6.4.5]; in units of omega per length.
///
/// v = (omega_1 e_2 - omega_2 e_1) x N / (2A). Then sum_f A_f <v, v'> = sum_e w_e omega_e omega'_e.
/// \param omega |E| numbers, a closed 1-form: otherwise v fits only two edges of a face
/// \pre no face has area zero
template <class Derived>
Points tangent_field(const Mesh_view& mesh, const Eigen::MatrixBase<Derived>& omega)
{
  Points v(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const Eigen::Vector3d normal = mesh.double_area_vector(f);
    const Eigen::Vector3d turned = along_halfedge(mesh, omega, 3 * f + 1) * mesh.vector(3 * f + 2) -
                                   along_halfedge(mesh, omega, 3 * f + 2) * mesh.vector(3 * f + 1);
    v.col(f) = turned.cross(normal) / normal.squaredNorm();
  }
  return v;
}

}  // namespace Conformal_geometry_processing

#endif
