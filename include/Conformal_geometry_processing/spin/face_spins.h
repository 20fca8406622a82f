// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_FACE_SPINS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_FACE_SPINS_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the spins of the similarities of the faces that come nearest to a deformation, |F| of
/// either sign [CGP 5.9, 6.3].
///
/// Between a face and its image is a linear map; its nearest rotation, times the root of its
/// determinant, is conjugate(q) v q for the edges v. Two quaternions, q and -q, belong to it.
/// \param positions of the deformed surface, 3 x |V|
/// \pre no face has area zero before or after
Quaternion_vector<double> face_spins(const Mesh_view& mesh, const Points& positions);

/// \ingroup PkgSpin
/// \brief gives faces that are thin before or after, whose own spins are decided by rounding or do
/// not exist, the mean of their neighbours', ring by ring from the others.
///
/// A face is thin if its height is less than a thousandth of its longest edge.
void replace_thin_faces(const Mesh_view& mesh, const Points& positions,
                        Quaternion_vector<double>& spins);

/// \ingroup PkgSpin
/// \brief chooses the signs of face spins such that they agree with those of their neighbours along
/// a spanning tree of the faces.
///
/// Without, the mean over the faces at a vertex would be of arbitrary signs as soon as rotations
/// exceed half a turn.
/// \returns how many edges have opposite signs on their sides: of a deformation that is smooth at
/// the scale of the faces none, unless it is of another spin structure
int make_consistent(const Mesh_view& mesh, Quaternion_vector<double>& spins);

/// \ingroup PkgSpin
/// the mean of the faces around each vertex, weighted by area, |V|
Quaternion_vector<double> vertex_spins(const Mesh_view& mesh,
                                       const Quaternion_vector<double>& face_spins);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/face_spins_impl.h>
#endif

#endif
