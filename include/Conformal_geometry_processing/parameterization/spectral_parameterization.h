// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_SPECTRAL_PARAMETERIZATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_SPECTRAL_PARAMETERIZATION_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/parameterization/Least_energy_map.h>
#include <Conformal_geometry_processing/parameterization/Parameterization_report.h>
#include <Conformal_geometry_processing/parameterization/conformal_energy.h>
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>
#include <Conformal_geometry_processing/parameterization/vertex_normal_energy.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief whose normals N are in the energy |D psi|^2 of psi = a - b N [CGP 6.1].
enum class Conformal_normals {
  of_faces,    ///< the conformal energy itself, see `conformal_energy()`
  of_vertices  ///< the variant of the thesis, see `vertex_normal_energy()`
};

/// \ingroup PkgParameterization
/// what a spectral parameterization may be told
struct Parameterization_options {
  Conformal_normals normals = Conformal_normals::of_faces;
  Normal_weight vertex_normals = Normal_weight::angle;  ///< of `Conformal_normals::of_vertices`
  Normalized_boundary boundary = Normalized_boundary::longest_loop;
  double tolerance = 1e-6;  ///< of the map, relative, in the norm of the energy
  int maximum_number_of_iterations = 100;
};

/// \ingroup PkgParameterization
/// a map to the plane and its certificate
struct Parameterization_result {
  Eigen::VectorXcd z;  ///< u + i v for each vertex, in the units of the mesh
  Parameterization_report report;
};

/// \ingroup PkgParameterization
/// at least one edge has a face on one side only
void require_boundary(const Mesh_view& mesh, const std::string& function);

namespace internal {

/// the map of least energy in the frame of the computation, which tells the report about itself
template <class SolverTraits>
Eigen::VectorXcd least_energy_map(const Mesh_view& mesh, const std::vector<Vertex_loop>& loops,
                                  const Parameterization_options& options,
                                  Parameterization_report& report, const std::string& function)
{
  const Subspace_options subspace{options.tolerance, options.maximum_number_of_iterations};
  const auto graph = vertex_graph(mesh);
  Stopwatch watch;
  if (options.normals == Conformal_normals::of_faces) {
    const auto energy = conformal_energy(mesh, graph);
    report.seconds.assembly = watch.lap();
    return Least_energy_map<SolverTraits>(mesh, loops, function).find(energy, subspace, report);
  }
  const auto energy =
      vertex_normal_energy(mesh, vertex_normals(mesh, options.vertex_normals), *graph);
  report.seconds.assembly = watch.lap();
  return Least_energy_map<SolverTraits>(mesh, loops, function).find(energy, subspace, report);
}

void certify(const Mesh_view& mesh, const Eigen::VectorXcd& z, Parameterization_report& report);

}  // namespace internal

/// \ingroup PkgParameterization
/// \brief the same as `spectral_parameterization()`, with the spread of other curves kept than
/// whole boundary loops of the mesh.
/// \param loops one at least, the first one of three vertices or more; it is centred at the origin
/// \pre the mesh fulfils what `spectral_parameterization()` requires
template <class SolverTraits = Default_solver_traits>
Parameterization_result spectral_parameterization_of(Mesh_view mesh,
                                                     const std::vector<Vertex_loop>& loops,
                                                     const Parameterization_options& options,
                                                     const std::string& function)
{
  const Normalized_frame frame(mesh.positions());
  mesh.set_positions(frame.to_frame(mesh.positions()));
  Parameterization_result result;
  result.z =
      internal::least_energy_map<SolverTraits>(mesh, loops, options, result.report, function);
  result.z = place_in_plane(mesh, std::move(result.z), loops[0]);
  Stopwatch watch;
  internal::certify(mesh, result.z, result.report);
  result.report.seconds.certificate = watch.lap();
  result.z *= frame.unit();
  return result;
}

/// \ingroup PkgParameterization
/// \brief the map to the plane of least conformal energy among those whose boundary is spread as
/// wide, by an eigenvector [CGP 6.1].
///
/// mu is the least of |D psi|^2 / (sum of |z - mean|^2 over the boundary), psi = a - b N. With the
/// normals of the faces this is the spectral conformal parameterization of Mullen et al., a complex
/// Hermitian problem with as many unknowns as vertices; no vertex is pinned, so it does not depend
/// on the choice of one. One factorization and a few solves.
///
/// The image has its longest loop centred at the origin, the first vertex of it on the positive u
/// axis, and as much area in its faces as the surface. Neither scale nor position of the mesh
/// matter. A surface with holes is mapped to a plane domain with holes; one with handles has no
/// such map without flipped faces.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`, for `std::complex<double>` too
/// \throw Precondition_error if the mesh is not a connected, oriented manifold with boundary,
/// finite coordinates and positive areas \throw Solver_error if the energy cannot be factorized. No
/// convergence is a field of the report.
template <class SolverTraits = Default_solver_traits>
Parameterization_result spectral_parameterization(
    const Mesh_view& mesh, const Parameterization_options& options = {},
    const std::string& function = "spectral_parameterization")
{
  require_surface(mesh, function);
  require_boundary(mesh, function);
  return spectral_parameterization_of<SolverTraits>(mesh, normalized_loops(mesh, options.boundary),
                                                    options, function);
}

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/parameterization/spectral_parameterization_impl.h>
#endif

#endif
