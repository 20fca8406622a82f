// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the spins of the similarities nearest to the deformation of each face, |F| of either sign
/// [CGP 5.9, 6.3].
///
/// A linear map takes a face to its image; its nearest rotation, times the square root of its
/// determinant, maps the edges v to conjugate(q) v q. Both q and -q represent it.
/// \param positions of the deformed surface, 3 x |V|
/// \pre no face has area zero before or after
Quaternion_vector<double> face_spins(const Mesh_view& mesh, const Points& positions);

namespace internal {

/// whether the height of a face is less than a thousandth of its longest edge
bool is_thin(const Mesh_view& mesh, int f);

}  // namespace internal

/// \ingroup PkgSpin
/// \brief replaces the spins of faces that are thin before or after the deformation, which depend
/// on rounding or do not exist, by the mean of their neighbours, ring by ring.
void replace_thin_faces(const Mesh_view& mesh, const Points& positions,
                        Quaternion_vector<double>& spins);

/// \ingroup PkgSpin
/// \brief chooses the signs of face spins such that they agree with those of their neighbours along
/// a spanning tree of the faces.
///
/// Otherwise the mean over the faces at a vertex would have arbitrary signs once rotations exceed
/// half a turn.
/// \returns the number of edges with opposite signs on their sides: zero for deformations that are
/// smooth at the scale of the faces, unless the spin structures differ
int make_consistent(const Mesh_view& mesh, Quaternion_vector<double>& spins);

/// \ingroup PkgSpin
/// the area-weighted mean of the faces around each vertex, |V|
Quaternion_vector<double> vertex_spins(const Mesh_view& mesh,
                                       const Quaternion_vector<double>& face_spins);

}  // namespace Conformal_geometry_processing
