// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/spin/snap_to_class.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief flips edges until the faces are those of a Delaunay triangulation of the surface: no two
/// angles opposite to an edge have a sum above pi, but where a flip would join two vertices twice
/// or leave a face without area.
///
/// `conformal_willmore_flow()` computes on that triangulation, and stops where it leaves the limits
/// on the faces of the mesh, which may be slivers. Called before, this function makes the two the
/// same. Vertices, their points, and the boundary stay; edges across a crease cut or fill it.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements; also a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the surface, whose edges are flipped; descriptors stay valid
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map, geom_traits}
///     \cgalParamDescription{see `conformal_parameterization()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the number of flips
/// \throw Precondition_error if the mesh is not an oriented manifold triangle mesh with finite
/// coordinates, or an edge has length zero. The mesh is then unchanged
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
int make_delaunay(TriangleMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::only_known_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                                CGAL::internal_np::geom_traits_t>,
                "make_delaunay(): unknown named parameter, see the manual for those it accepts");
  const std::string function = "make_delaunay";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  internal::require_edge_lengths(graph.view(), function);
  std::vector<std::array<int, 2>> flips;
  (void)internal::delaunay_by_chords(graph.view(), 0, flips);
  for (const auto& [a, b] : flips)
    CGAL::Euler::flip_edge(halfedge(graph.vertex(a), graph.vertex(b), mesh).first, mesh);
  return static_cast<int>(flips.size());
}

}  // namespace Conformal_geometry_processing
