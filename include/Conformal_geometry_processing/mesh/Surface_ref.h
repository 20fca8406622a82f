// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_part.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief a reference to any model of `ConformalSurface`: the parameter type of the operators,
/// which are compiled once for all models.
///
/// Converts from `Mesh_view`, `Delaunay_view` or a user-defined model. Copying costs as much as
/// copying three pointers; accessing a sheet costs one indirect call. The surface must outlive the
/// reference.
class Surface_ref {
 public:
  template <class Surface, class = decltype(std::declval<const Surface&>().sheet(0).share),
            class = decltype(std::declval<const Surface&>().ends())>
  Surface_ref(const Surface& surface)
      : m_surface(&surface),
        m_functions(&functions<Surface>),
        m_positions(&surface.positions()),
        m_ends(&surface.ends())
  {}

  const Points& positions() const { return *m_positions; }
  Eigen::Vector3d position(int v) const { return m_positions->col(v); }
  int size_of_vertices() const { return static_cast<int>(m_positions->cols()); }

  /// number of faces of the mesh
  int size_of_faces() const { return m_functions->size_of_faces(m_surface); }

  int size_of_edges() const { return static_cast<int>(m_ends->size()); }

  /// the ends of edge k, the smaller number first
  const std::array<int, 2>& ends(int k) const { return (*m_ends)[static_cast<std::size_t>(k)]; }

  int size_of_sheets() const { return m_functions->size_of_sheets(m_surface); }
  Sheet sheet(int i) const { return m_functions->sheet(m_surface, i); }

  /// see `boundary_loops()`
  std::vector<std::vector<int>> loops() const { return m_functions->loops(m_surface); }

 private:
  struct Functions {
    int (*size_of_faces)(const void*);
    int (*size_of_sheets)(const void*);
    Sheet (*sheet)(const void*, int);
    std::vector<std::vector<int>> (*loops)(const void*);
  };

  template <class Surface>
  static const Surface& as(const void* surface)
  {
    return *static_cast<const Surface*>(surface);
  }

  template <class Surface>
  static constexpr Functions functions = {
      [](const void* s) { return as<Surface>(s).size_of_faces(); },
      [](const void* s) { return as<Surface>(s).size_of_sheets(); },
      [](const void* s, int i) { return as<Surface>(s).sheet(i); },
      [](const void* s) { return boundary_loops(as<Surface>(s)); }};

  const void* m_surface;
  const Functions* m_functions;
  const Points* m_positions;
  const std::vector<std::array<int, 2>>* m_ends;
};

/// \ingroup PkgMesh
/// the boundary loops of the referenced surface
inline std::vector<std::vector<int>> boundary_loops(const Surface_ref& surface)
{
  return surface.loops();
}

/// \ingroup PkgMesh
/// for each vertex, whether it lies on the boundary
inline std::vector<char> boundary_vertices(const Surface_ref& surface)
{
  std::vector<char> is_boundary(static_cast<std::size_t>(surface.size_of_vertices()), 0);
  for (const std::vector<int>& loop : surface.loops())
    for (const int v : loop) is_boundary[static_cast<std::size_t>(v)] = 1;
  return is_boundary;
}

/// \ingroup PkgMesh
/// the mean length h of the edges
/// \pre there is an edge
double mean_edge_length(const Surface_ref& surface, const internal::Surface_part& part = {});

}  // namespace Conformal_geometry_processing
