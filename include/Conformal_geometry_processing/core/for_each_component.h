// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/mesh/Mesh_component.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief Calls `work(graph)` with a view of each component in turn, and `take(vertices, result)`
/// with the indices of its vertices in the whole mesh and the result, which has a `report`.
///
/// All components are created first; the memory of each one is released before the next one begins.
/// \throw Precondition_error, Solver_error see `Component_failures`
template <class TriangleMesh, class Work, class Take>
auto for_each_component(const Graph_view<TriangleMesh>& whole, const std::string& function,
                        const Work& work, const Take& take)
{
  using Report = decltype(work(whole).report);
  std::vector<Mesh_component> parts = mesh_components(whole.view());
  Component_failures failures(parts.size(), function);
  Component_reports<Report> all;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    const std::vector<int> vertices = parts[c].vertices;
    const Graph_view<TriangleMesh> component(whole, std::move(parts[c]));
    failures.attempt(c, vertices.front(), [&] {
      auto result = work(component);
      take(vertices, result);
      all.components.push_back({vertices.front(), component.view().size_of_vertices(),
                                component.view().size_of_faces(), std::move(result.report)});
    });
  }
  failures.throw_if_any();
  return all;
}

}  // namespace Conformal_geometry_processing::internal
