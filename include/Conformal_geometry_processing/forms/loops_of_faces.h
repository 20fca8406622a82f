// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgForms
/// \brief a loop from face to face that visits no face twice: the halfedges through which it leaves
/// the faces, in order.
using Face_loop = std::vector<int>;

}  // namespace internal

/// \ingroup PkgForms
/// \brief 2G loops of faces that generate the homology of a closed surface; the forms of
/// `closed_generators()` count crossings with these loops. Depends only on the connectivity.
///
/// O(|V| + |F|) plus the lengths of the loops.
/// \pre the surface is closed, and `require_surface(mesh)` holds
std::vector<internal::Face_loop> loops_of_faces(const Mesh_view& mesh);

/// \ingroup PkgForms
/// \brief the numbers of crossings between loops of faces, modulo 2: a symmetric matrix with zeros
/// on the diagonal, of odd determinant if the loops are a basis of the homology.
Eigen::MatrixXi crossings_modulo_2(const Mesh_view& mesh,
                                   const std::vector<internal::Face_loop>& loops);

}  // namespace Conformal_geometry_processing
