// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_ROTATED_NORMALS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_ROTATED_NORMALS_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the expected normals of the faces after a spin transformation: rotated by the mean spin
/// of their corners, 3 x |F|, not normalised.
Points rotated_normals(const Mesh_view& mesh, const Quaternion_vector<double>& lambda);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/rotated_normals_impl.h>
#endif

#endif
