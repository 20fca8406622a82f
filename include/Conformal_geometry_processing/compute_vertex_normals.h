// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <boost/property_map/property_map.hpp>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Computes the area-weighted unit normals of the vertices; zero if the incident faces
/// cancel out. In `double`, for any kernel.
///
/// \tparam TriangleMesh a triangle mesh, see \ref triangle_mesh_requirements
/// \tparam VertexNormalMap a model of `WritablePropertyMap`, from vertices to a type that is
/// constructed from three numbers, such as `Vector_3`
/// \param mesh may have a boundary
/// \param normals written after all have been computed
/// \param np optional, as follows
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map, geom_traits}
///     \cgalParamDescription{see `conformal_parameterization()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Precondition_error if a face is not a triangle
template <class TriangleMesh, class VertexNormalMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
void compute_vertex_normals(const TriangleMesh& mesh, VertexNormalMap normals,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  static_assert(internal::only_known_parameters<CGAL_NP_CLASS, CGAL::internal_np::vertex_point_t,
                                                CGAL::internal_np::geom_traits_t>,
                "compute_vertex_normals(): unknown named parameter");
  using Vector = typename boost::property_traits<VertexNormalMap>::value_type;
  const Graph_view<TriangleMesh> graph(mesh, np, "compute_vertex_normals");
  const Points computed = vertex_normals(graph.view());
  for (int v = 0; v < graph.view().size_of_vertices(); ++v)
    put(normals, graph.vertex(v), Vector(computed(0, v), computed(1, v), computed(2, v)));
}

}  // namespace Conformal_geometry_processing
