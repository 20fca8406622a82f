// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <functional>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
/// \brief the closed curves of edges that marked vertices form, each with its vertices in order.
///
/// A curve begins at its vertex of smallest number. O(|V| + |E|).
/// \param is_marked |V|
/// \param name of a vertex in errors
/// \throw Precondition_error if a marked vertex has more or fewer than two marked neighbours
std::vector<std::vector<int>> closed_curves(
    const Mesh_view& mesh, const std::vector<char>& is_marked, const std::string& function,
    const std::function<std::string(int)>& name = name_of_vertex);

}  // namespace Conformal_geometry_processing::internal
