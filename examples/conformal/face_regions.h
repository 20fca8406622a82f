// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_FACE_REGIONS_H
#define CONFORMAL_FACE_REGIONS_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// \brief The region of each face, numbered from 0: connected ones of about the same extent, the
/// faces nearest to seeds that are far from each other.
/// \param count how many; more where there are more components, for regions are connected
std::vector<int> face_regions(const CGP::Mesh_view& mesh, int count);

}  // namespace conformal

#endif
