// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Shortest_paths.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace conformal {

/// vertices at the tips of a connected mesh: each is as far as possible from those before it
/// \param count how many, at most all vertices
/// \param ways the edges along which distances are measured
std::vector<int> find_tips(const CGP::Mesh_view& mesh, int count, const Edge_set& ways);

/// \brief A short graph that contains the tips, and outside which a surface is a disk: the shortest
/// paths from the tips to the first of them, or to the boundary and from hole to hole, and, for
/// each handle, two loops of shortest paths [Erickson and Whittlesey 2005]. O(|E| log |E|)
/// \param tips at least one, if the mesh is closed
/// \param ways the edges of which it may consist, the boundary among them
/// \pre the mesh is connected, and so are the ways
Edge_set cut_graph(const CGP::Mesh_view& mesh, const std::vector<int>& tips, const Edge_set& ways);

}  // namespace conformal
