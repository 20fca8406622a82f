// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/boundary_parameters.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>

#include <string>

namespace Conformal_geometry_processing {
namespace internal {

template <class NamedParameters>
Dirac_spectrum_options dirac_spectrum_options(const NamedParameters& np)
{
  Dirac_spectrum_options o;
  read_parameter(np, internal_np::spectral_shift, o.shift);
  read_parameter(np, internal_np::tolerance, o.tolerance);
  read_parameter(np, CGAL::internal_np::number_of_iterations, o.max_restarts);
  read_parameter(np, CGAL::internal_np::random_seed, o.random_seed);
  return o;
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief Computes eigenvalues of D - rho and their eigenfunctions: those of smallest modulus, or
/// those nearest to a shift, with their sign [CGP 5.8.2].
///
/// On the unit sphere with rho = 0 they are all integers n except -1, with quaternionic
/// multiplicity |n + 1|; constants belong to 0. Each eigenfunction lambda is the spin of a surface
/// whose mean curvature half-density is a multiple of its length density, a Dirac surface.
///
/// On a surface with boundary, directions that are orthogonal to its tangents are preserved or
/// prescribed: by default the binormals. Then the eigenspaces are real vector spaces.
///
/// Computes in double precision for any kernel. One factorization, and for each eigenvalue a few
/// solves and, for each pair of eigenvalues, several hundred operations per vertex: a hundred
/// eigenvalues on 8 000 triangles take seconds. Eigenvalues have an error of O(h^2), also those at
/// the shift; see `Dirac_spectral_problem`, the class for several rho on one mesh.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param mesh the surface, oriented with normals outward
/// \param count number of eigenvalues, at least one
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map, geom_traits}
///     \cgalParamDescription{see `conformal_parameterization()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_solver, random_seed}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{curvature_potential_map}
///     \cgalParamDescription{rho, in 1/length}
///     \cgalParamType{a model of `CurvaturePotentialMap`}
///     \cgalParamDefault{zero}
///   \cgalParamNEnd
///   \cgalParamNBegin{spectral_shift}
///     \cgalParamDescription{computes the eigenvalues nearest to it, in 1/length}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction}
///     \cgalParamDescription{the direction in the boundary frame that is preserved or prescribed}
///     \cgalParamType{`Boundary_direction`, orthogonal to the tangent and not the normal}
///     \cgalParamDefault{the binormal}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction_map}
///     \cgalParamDescription{the prescribed direction, for each vertex on the boundary}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    vector, not zero, as value; needs `boundary_direction`}
///     \cgalParamDefault{the direction before}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{bound on the residuals of the discrete problem}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-8}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{maximal number of restarts}
///     \cgalParamType{`int`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the eigenvalues nearest to the shift first; rows of the vectors are in the order of
/// `vertices(mesh)`. Check `is_complete()`: where the mesh does not resolve all that are asked for,
/// there may be fewer, and some may be missing beyond `complete_radius`.
/// \throw Precondition_error if the mesh is not a connected, oriented manifold triangle mesh with
/// finite coordinates and positive areas, if the directions do not fit it, or if `count` exceeds
/// the number of eigenvalues
/// \throw Solver_error if a matrix cannot be factored
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
internal::Dirac_spectrum dirac_spectrum(const TriangleMesh& mesh, int count,
                                        const NamedParameters& np = parameters::default_values())
{
  static_assert(
      internal::only_known_parameters<
          NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::random_seed_t,
          internal_np::sparse_solver_t, internal_np::tolerance_t,
          internal_np::curvature_potential_map_t, internal_np::spectral_shift_t,
          internal_np::boundary_direction_t, internal_np::boundary_direction_map_t>,
      "dirac_spectrum(): unknown named parameter, see the manual for those it accepts");
  const std::string function = "dirac_spectrum";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  require_surface(graph.view(), function);
  Boundary_condition condition = internal::boundary_condition(graph, np, function);
  if (condition.kind == Boundary_condition::Kind::free && !boundary_loops(graph.view()).empty())
    condition = Boundary_condition::binormals();
  Curvature_potential rho = no_potential(graph.view());
  if constexpr (internal::has_parameter<NamedParameters, internal_np::curvature_potential_map_t>)
    rho = internal::read_curvature_potential(
        graph, CGAL::parameters::get_parameter(np, internal_np::curvature_potential_map));
  internal::Dirac_spectral_problem problem(graph.view(), condition, function,
                                           internal::spin_solvers(np));
  return problem.find(rho, count, internal::dirac_spectrum_options(np));
}

}  // namespace Conformal_geometry_processing
