// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
/// \ingroup PkgForms
/// \brief closed 1-forms whose classes are a basis of the cohomology with integer coefficients: 2G
/// on a closed surface, 2G + loops - 1 with boundary. A matrix of |E| rows and integer entries,
/// mostly 0.
///
/// Tree-cotree decomposition: the edges that are neither crossed by a spanning tree of the faces
/// nor contained in a spanning tree of the vertices are as many. Each of them closes a loop in the
/// tree of faces, whose form is 1 on the edges that it crosses from left to right (seen along the
/// edge i -> j, i < j), and -1 on those crossed from right to left. The sum around a face is
/// exactly zero, because the loop leaves the face as often as it enters; the integral along a curve
/// is the number of its crossings with the loop. Loops may pass through the outside, as if all
/// holes were one face; the form then belongs to a path from boundary to boundary. Depends only on
/// the connectivity.
///
/// O(|V| + |F|) plus the lengths of the loops.
/// \pre `require_surface(mesh)` holds
Eigen::MatrixXd closed_generators(const Mesh_view& mesh);

namespace internal {

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
