// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/surfaces/spheres.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Transforms a mesh of a round sphere to a Dirac sphere: a conformal image whose mean
/// curvature half-density is a multiple of its length density, with Willmore energy 4 pi kappa^2
/// [CGP 6.5.1].
///
/// Its spin is the spherical spinor Omega_kappa,s in closed form, about the axis z. For s = 0 the
/// surface is immersed, otherwise it has branch points at both poles. For surfaces of other
/// eigenfunctions see `dirac_spectrum()` and `surface_of_spin()`.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a round sphere with normals outward, of any position and size; its points are
/// overwritten, area and centroid are preserved
/// \param kappa any integer except zero; -1 gives the sphere itself
/// \param s from -|kappa| to |kappa| - 1; -s - 1 gives the same surface as s
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map, output_vertex_point_map, geom_traits, sparse_solver}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_spin_map}
///     \cgalParamDescription{receives lambda}
///     \cgalParamType{a model of `WritablePropertyMap` whose value type is supported by
///                    `Quaternion_access`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report; `eigenvalue` is approximately -(kappa + 1) divided by the radius
/// \throw Precondition_error if kappa is zero, s is out of its range, or the mesh is not a closed
/// round sphere with normals outward, finite coordinates and positive areas
/// \throw Solver_error if the Laplacian cannot be factored
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Spin_report dirac_sphere(TriangleMesh& mesh, int kappa, int s,
                         const NamedParameters& np = parameters::default_values())
{
  static_assert(
      internal::only_known_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                      CGAL::internal_np::geom_traits_t,
                                      internal_np::output_vertex_point_map_t,
                                      internal_np::vertex_spin_map_t, internal_np::sparse_solver_t>,
      "dirac_sphere(): unknown named parameter, see the manual for those it accepts");
  const Graph_view<TriangleMesh> graph(mesh, np, "dirac_sphere");
  const Spin_result result =
      spin_to_dirac_sphere(graph.view(), kappa, s, "dirac_sphere", internal::spin_solvers(np));
  if (result.report.converged) internal::write_spin_result(mesh, graph, result, np);
  return result.report;
}

}  // namespace Conformal_geometry_processing
