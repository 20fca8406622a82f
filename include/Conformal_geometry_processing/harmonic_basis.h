// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/Harmonic_forms.h>
#include <Conformal_geometry_processing/core/dirac_parameters.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Computes the harmonic 1-forms of a surface and their tangent fields, orthonormal: 2G of
/// them for genus G, and 2G + L - 1 with L boundary loops [CGP 6.4.5.1].
///
/// Harmonic forms are closed and co-closed: they integrate to zero around each face, and their
/// weighted sum around each vertex is zero. At a boundary their fields are therefore tangent to it
/// (forms of Neumann type). They represent the cohomology of the surface: directions along its
/// handles and around its holes. Spheres and disks have none.
///
/// Computes in double precision for any kernel. Takes one factorization of the Laplacian and two
/// solves per form. The orthonormal basis depends on the order of the vertices and faces.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param mesh the surface
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamType{a model of `ConformalGeometryTraits_3`}
///     \cgalParamDefault{the kernel of the points}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_solver}
///     \cgalParamDescription{the linear solver; only its type matters, not its value}
///     \cgalParamType{a model of `SparseHermitianSolverTraits`}
///     \cgalParamDefault{`Default_solver_traits`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the forms; vectors are those of the kernel of the points, or Eigen's if they have none
/// \throw Precondition_error if the mesh is not a connected, oriented triangle mesh with finite
/// coordinates and positive areas; the message names the element
/// \throw Solver_error if the Laplacian cannot be factored
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
auto harmonic_basis(const TriangleMesh& mesh,
                    const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::only_known_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                                CGAL::internal_np::geom_traits_t,
                                                internal_np::sparse_solver_t>,
                "harmonic_basis(): unknown named parameter, see the manual for those it accepts");
  using Vector = internal::Vector_of<internal::Point_of<TriangleMesh, NamedParameters>>;
  const std::string function = "harmonic_basis";

  const Graph_view<TriangleMesh> graph(mesh, np, function);
  require_not_empty(graph.view(), function);
  require_finite_positions(graph.view(), function);
  const internal::Normalized_frame frame(graph.view().positions());
  Mesh_view view = graph.view();
  view.set_positions(frame.to_frame(view.positions()));
  Harmonic_basis basis =
      Hodge_decomposition(view, function, internal::spin_solvers(np)).harmonic_basis();
  return internal::Harmonic_forms<TriangleMesh, Vector>(mesh, graph, std::move(basis),
                                                        1 / frame.unit());
}

}  // namespace Conformal_geometry_processing
