// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
/// The report of an algorithm on one component of a mesh
template <class Report>
struct Component_report {
  int first_vertex = 0;  ///< its number among the vertices of the mesh, from 0
  int size_of_vertices = 0, size_of_faces = 0;
  Report report;
};

/// \ingroup PkgMesh
/// \brief The reports of an algorithm that processes each component of a mesh separately, in the
/// order of their first vertices.
template <class Report>
struct [[nodiscard]] Component_reports {
  std::vector<Component_report<Report>> components;

  /// Returns whether all components succeeded
  explicit operator bool() const
  {
    return std::all_of(components.begin(), components.end(),
                       [](const auto& c) { return static_cast<bool>(c.report); });
  }
};

}  // namespace Conformal_geometry_processing::internal
