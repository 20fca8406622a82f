// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// \brief Computes the region of each face, numbered from 0: regions are connected and of similar
/// extent, and consist of the faces nearest to distant seeds.
/// \param count number of regions; exceeded if there are more components
std::vector<int> face_regions(const CGP::Mesh_view& mesh, int count);

}  // namespace conformal
