// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/fair_region.h>

#include <vector>

#include "support/mesh_tools.h"

namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

/// the faces whose centroid is inside
template <class Is_inside>
std::vector<char> region_where(const Mesh_view& mesh, Is_inside is_inside)
{
  std::vector<char> region;
  for (const auto& [a, b, c] : mesh.corners()) {
    const Eigen::Vector3d centroid = (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3;
    region.push_back(is_inside(centroid) ? 1 : 0);
  }
  return region;
}

inline CGP::internal::Fairing_result faired(const Mesh_view& mesh, const std::vector<char>& region,
                                            const CGP::internal::Fairing_options& options)
{
  return CGP::internal::fair_region(mesh, region, options, "test", [] { return true; });
}

/// a mesh whose free vertices are moved by map(p)
template <class Map>
Mesh_view refilled(const Mesh_view& mesh, const std::vector<char>& region, Map map)
{
  const CGP::internal::Fairing_patch patch(mesh, region, "test");
  Points f = mesh.positions();
  for (int k = 0; k < patch.size(); ++k) {
    const int v = patch.vertices()[at(patch.free_vertex(k))];
    const Eigen::Vector3d p = mesh.position(v);
    f.col(v) = map(p);
  }
  return {std::move(f), mesh.corners()};
}

}  // namespace cgp_test
