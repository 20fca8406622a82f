// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_DIRAC_SPECTRUM_H
#define CONFORMAL_GEOMETRY_PROCESSING_DIRAC_SPECTRUM_H

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/boundary_parameters.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/read_curvature_potential.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>
#include <Conformal_geometry_processing/spin/Dirac_spectral_problem.h>

#include <string>

namespace Conformal_geometry_processing {
namespace internal {

template <class NamedParameters>
Dirac_spectrum_options dirac_spectrum_options(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Dirac_spectrum_options o;
  o.shift = choose_parameter(get_parameter(np, internal_np::spectral_shift), o.shift);
  o.tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), o.tolerance);
  o.max_restarts = static_cast<int>(
      choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), o.max_restarts));
  o.random_seed = static_cast<unsigned>(
      choose_parameter(get_parameter(np, CGAL::internal_np::random_seed), o.random_seed));
  return o;
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief finds eigenvalues of D - rho and their eigenfunctions: those of the smallest modulus, or
/// those nearest to a shift, with their sign [CGP 5.8.2].
///
/// Of the unit sphere with rho = 0 they are all integers n but -1, |n + 1| times over the
/// quaternions; constants belong to 0. Each eigenfunction lambda is the spin of a surface whose
/// mean curvature half-density is a multiple of its length density, a Dirac surface.
///
/// On a surface with boundary, directions that are orthogonal to its tangents are kept or
/// prescribed: by default the binormals. Then eigenfunctions are spaces over the reals.
///
/// Computes in double precision whatever the kernel. One factorization, and a few solves and
/// several hundred operations per vertex for each eigenvalue and each other: a hundred of them on
/// 8 000 triangles take seconds. Eigenvalues err by O(h^2); those too near to the shift by more,
/// see `Dirac_spectral_problem`, which is the class to use for several rho on one mesh.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param mesh the surface, oriented with normals outward
/// \param count how many eigenvalues, at least one
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
///     \cgalParamDescription{which linear solver to use; its type matters, not its value}
///     \cgalParamType{a model of `SparseHermitianSolverTraits`}
///     \cgalParamDefault{`Default_solver_traits`}
///   \cgalParamNEnd
///   \cgalParamNBegin{curvature_potential_map}
///     \cgalParamDescription{rho, in 1/length}
///     \cgalParamType{a model of `CurvaturePotentialMap`}
///     \cgalParamDefault{zero}
///   \cgalParamNEnd
///   \cgalParamNBegin{spectral_shift}
///     \cgalParamDescription{the eigenvalues nearest to it, in 1/length}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction}
///     \cgalParamDescription{which direction of the boundary frame is kept or prescribed}
///     \cgalParamType{`Boundary_direction`, orthogonal to the tangent and not the normal}
///     \cgalParamDefault{the binormal}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction_map}
///     \cgalParamDescription{what it becomes, for each vertex on the boundary}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    vector, not zero, as value; needs `boundary_direction`}
///     \cgalParamDefault{what it is}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{on the residuals of the discrete problem}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-8}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{how many restarts at most}
///     \cgalParamType{`int`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the eigenvalues nearest to the shift first; rows of the vectors are in the order of
/// `vertices(mesh)`. Look at `converged`.
/// \throw Precondition_error if the mesh is not a connected, oriented manifold triangle mesh with
/// finite coordinates and positive areas, if the directions do not fit it, or if there are not so
/// many eigenvalues
/// \throw Solver_error if a matrix cannot be factored
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Dirac_spectrum dirac_spectrum(const TriangleMesh& mesh, int count,
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
  using Solver_traits = internal::Parameter_type<NamedParameters, internal_np::sparse_solver_t,
                                                 Default_solver_traits>;
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
  Dirac_spectral_problem<Solver_traits> problem(graph.view(), condition, function);
  return problem.find(rho, count, internal::dirac_spectrum_options(np));
}

}  // namespace Conformal_geometry_processing

#endif
