// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Measurements of a canonical metric, returned by `canonical_metric()`.
struct Canonical_metric_report {
  int genus = 0;
  double area = 0;         ///< in the canonical metric: the genus, up to rounding
  double min_density = 0;  ///< over the faces, in 1/area of the mesh
  double max_density = 0;
};

/// \ingroup PkgEntryPoints
/// \brief Computes the area density of the canonical metric of a closed surface of genus > 0
/// relative to the area of faces or around vertices, in 1/area of the mesh [CGP 4.5.3].
///
/// The canonical metric depends on the conformal structure only; its total area is the genus. It
/// is u = 1/2 sum |v_i|^2 times the metric of the surface, for an orthonormal basis v_i of the
/// harmonic fields. On a torus it is flat. Takes 4G solves with the Laplacian, for genus G.
///
/// \tparam TriangleMesh a triangle mesh, see \ref triangle_mesh_requirements
/// \tparam DensityMap a model of `WritablePropertyMap` whose key is the face or the vertex
/// descriptor of the mesh, and whose value is constructed from a `double`
/// \param mesh the surface
/// \param density written after all values have been computed; at vertices the area-weighted mean
/// of the incident faces
/// \param np optional, as follows
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map, geom_traits}
///     \cgalParamDescription{see `conformal_parameterization()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_solver}
///     \cgalParamDescription{the linear solver; only its type matters, not its value}
///     \cgalParamType{a model of `SparseHermitianSolverTraits`}
///     \cgalParamDefault{`Default_solver_traits`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Precondition_error if the mesh is not a closed, connected, oriented triangle mesh of
/// genus 1 or more with finite coordinates and positive areas; the message names the element
/// \throw Solver_error if the Laplacian cannot be factored
template <class TriangleMesh, class DensityMap,
          class NamedParameters = parameters::Default_named_parameters>
Canonical_metric_report canonical_metric(const TriangleMesh& mesh, DensityMap density,
                                         const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::only_known_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                                CGAL::internal_np::geom_traits_t,
                                                internal_np::sparse_solver_t>,
                "canonical_metric(): unknown named parameter");
  using Graph = Graph_view<TriangleMesh>;
  using Key = typename boost::property_traits<DensityMap>::key_type;
  using Value = typename boost::property_traits<DensityMap>::value_type;
  constexpr bool on_vertices = std::is_same_v<Key, typename Graph::vertex_descriptor>;
  static_assert(on_vertices || std::is_same_v<Key, typename Graph::face_descriptor>,
                "the key type of the map must be the vertex or the face descriptor of the mesh");

  const Graph graph(mesh, np, "canonical_metric");
  require_not_empty(graph.view(), "canonical_metric");
  require_finite_positions(graph.view(), "canonical_metric");
  const internal::Normalized_frame frame(graph.view().positions());
  Mesh_view view = graph.view();
  view.set_positions(frame.to_frame(view.positions()));
  require_closed(view, "canonical_metric");
  const double unit_area = frame.unit() * frame.unit();
  const Hodge_decomposition forms(view, "canonical_metric", internal::spin_solvers(np));
  const Eigen::VectorXd u =
      canonical_area_density(view, forms.harmonic_basis().one_forms, "canonical_metric");

  if constexpr (on_vertices) {
    const Eigen::VectorXd mean =
        canonical_vertex_areas(view, u).cwiseQuotient(vertex_areas(view)) / unit_area;
    for (int v = 0; v < view.size_of_vertices(); ++v) put(density, graph.vertex(v), Value(mean[v]));
  } else {
    for (int f = 0; f < view.size_of_faces(); ++f)
      put(density, graph.face(f), Value(u[f] / unit_area));
  }
  return {forms.harmonic_basis().genus(), face_areas(view).dot(u), u.minCoeff() / unit_area,
          u.maxCoeff() / unit_area};
}

}  // namespace Conformal_geometry_processing
