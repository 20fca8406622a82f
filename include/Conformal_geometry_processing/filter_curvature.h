// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/flow/Curvature_filter.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/painting/image_filters.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Filters a function on the vertices, such as rho or a height, by its frequencies on the
/// surface: (id + sigma Delta^k)^-1 and filters derived from it [CGP 6.2, 6.4.2.1].
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam VertexMap a model of `ReadWritePropertyMap` with the vertex descriptor as key and a
/// number as value
///
/// \param mesh the surface, with boundary or without
/// \param values are replaced by the filtered ones
/// \param band the frequencies that pass
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{filter}
///     \cgalParamDescription{its weight is for the surface scaled to area 4 pi}
///     \cgalParamType{`Filter_options`}
///     \cgalParamDefault{`Filter_options()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map, geom_traits}
///     \cgalParamDescription{see `conformal_parameterization()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_solver}
///     \cgalParamType{a model of `SparseHermitianSolverTraits`}
///     \cgalParamDefault{`Default_solver_traits`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Precondition_error if the mesh is not a connected, oriented manifold triangle mesh with
/// finite coordinates and positive areas, a value is not finite, or a parameter is out of its
/// range; then nothing is written
/// \throw Solver_error if a factorization fails
template <class TriangleMesh, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters>
void filter_curvature(const TriangleMesh& mesh, VertexMap values, Curvature_band band,
                      const NamedParameters& np = parameters::default_values())
{
  static_assert(
      internal::only_known_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                      CGAL::internal_np::geom_traits_t,
                                      internal_np::sparse_solver_t, internal_np::filter_t>,
      "filter_curvature(): unknown named parameter, see the manual for those it accepts");
  using Value = typename boost::property_traits<VertexMap>::value_type;
  const std::string function = "filter_curvature";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  require_surface(graph.view(), function);
  Eigen::VectorXd v = internal::read_vertex_numbers(graph, values);
  internal::refuse_if_any(
      static_cast<int>(v.size()), [&](int i) { return !std::isfinite(v[i]); },
      internal::name_of_vertex, function, "#value not finite", "finite values are needed");

  v = filtered_on_surface(graph.view(), v, band,
                          internal::parameter_or(np, internal_np::filter, Filter_options()),
                          internal::spin_solvers(np));
  for (int i = 0; i < v.size(); ++i) put(values, graph.vertex(i), Value(v[i]));
}

}  // namespace Conformal_geometry_processing
