// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/Distribution.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

void require_boundary(const Mesh_view& mesh, const std::string& function)
{
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0) return;
  throw Precondition_error(function,
                           "the surface is closed; one with a boundary is needed, cut it open");
}

namespace internal {

void certify(const Mesh_view& mesh, const Eigen::VectorXcd& z, Parameterization_report& report)
{
  const Points positions = in_space(z);
  Points upward = Points::Zero(3, mesh.size_of_faces());
  upward.row(2).setOnes();
  report.boundary_loops = static_cast<int>(boundary_loops(mesh).size());
  report.conformality = conformality(mesh, positions, upward);
  report.uniform_quasi_conformal = distribution(quasi_conformal_errors(mesh, positions),
                                                Eigen::VectorXd::Ones(mesh.size_of_faces()));
  report.converged = report.converged && z.allFinite();
}

}  // namespace internal
namespace internal {

Eigen::VectorXcd least_energy_map(const Mesh_view& mesh, const std::vector<Vertex_loop>& loops,
                                  const Parameterization_options& options,
                                  Parameterization_report& report, const std::string& function)
{
  const Subspace_options subspace{options.tolerance, options.maximum_number_of_iterations};
  const auto graph = vertex_graph(mesh);
  Stopwatch watch;
  if (options.normals == Parameterization_options::Normals::of_faces) {
    const auto energy = conformal_energy(mesh, graph);
    report.seconds.assembly = watch.lap();
    return Least_energy_map(mesh, loops, options.solvers, function).find(energy, subspace, report);
  }
  const auto energy =
      vertex_normal_energy(mesh, vertex_normals(mesh, options.vertex_normals), *graph);
  report.seconds.assembly = watch.lap();
  return Least_energy_map(mesh, loops, options.solvers, function).find(energy, subspace, report);
}

}  // namespace internal

internal::Parameterization_result spectral_parameterization_of(
    Mesh_view mesh, const std::vector<internal::Vertex_loop>& loops,
    const Parameterization_options& options, const std::string& function)
{
  const internal::Normalized_frame frame(mesh.positions());
  mesh.set_positions(frame.to_frame(mesh.positions()));
  internal::Parameterization_result result;
  result.z = internal::least_energy_map(mesh, loops, options, result.report, function);
  result.z = place_in_plane(mesh, std::move(result.z), loops[0]);
  internal::Stopwatch watch;
  internal::certify(mesh, result.z, result.report);
  result.report.seconds.certificate = watch.lap();
  result.z *= frame.unit();
  return result;
}

internal::Parameterization_result spectral_parameterization(const Mesh_view& mesh,
                                                            const Parameterization_options& options,
                                                            const std::string& function)
{
  require_surface(mesh, function);
  require_boundary(mesh, function);
  return spectral_parameterization_of(mesh, normalized_loops(mesh, options.boundary), options,
                                      function);
}

}  // namespace Conformal_geometry_processing
