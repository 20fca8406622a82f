// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

std::ostream& operator<<(std::ostream& out, const Parameterization_report& r)
{
  out << "eigenvector            " << (r.converged ? "found" : "NOT found") << ", residual "
      << r.residual << " after " << r.iterations << " iterations\n"
      << "eigenvalue             " << r.eigenvalue << " (next one " << r.next_eigenvalue << ")\n";
  internal::print_conformality(out, r.conformality);
  return out;
}

internal::Least_energy_map::Least_energy_map(const Mesh_view& mesh,
                                             const std::vector<internal::Vertex_loop>& loops,
                                             const Map_solvers& solvers, std::string function)
    : m_mesh(mesh),
      m_start(circle_maps(mesh, loops, (std::min)(4, static_cast<int>(loops[0].size()) - 1))),
      m_weights(Eigen::VectorXd::Zero(mesh.size_of_vertices())),
      m_solvers(solvers),
      m_function(std::move(function))
{
  for (const internal::Vertex_loop& loop : loops)
    for (const int v : loop) m_weights[v] = 1;
}

template <class Scalar>
double internal::Least_energy_map::factorize(const Hermitian_sparse_matrix<Scalar>& energy,
                                             const Eigen::VectorXd& weights,
                                             internal::Solver_ref<Scalar>& solver) const
{
  Solver_status status = Solver_status::success;
  for (const double constant : {1e-8, 1e-6, 1e-4}) {
    const double shift = constant / m_weights.sum();
    status = solver.factorize(energy, shift * weights);
    if (status == Solver_status::success) return shift;
    if (status != Solver_status::not_positive_definite) break;
  }
  check("factorization", status);
  return 0;
}

template <class Scalar>
Vector<Scalar> internal::Least_energy_map::eigenvector(
    const Hermitian_sparse_matrix<Scalar>& energy, internal::Solver_ref<Scalar>& solver,
    const internal::Centered_mass<Scalar>& mass, const Eigen::VectorXd& weights,
    const Block<Scalar>& start, const internal::Subspace_options& options,
    Parameterization_report& report) const
{
  internal::Stopwatch watch;
  const double shift = factorize(energy, weights, solver);
  report.seconds.factorization = watch.lap();
  internal::Subspace_result<Scalar> result =
      subspace_iteration(energy, mass, shift, solver, start, options);
  check("solution", result.status);
  report.seconds.eigenvector = watch.lap();
  report.converged = result.converged;
  report.eigenvalue = result.eigenvalue;
  report.next_eigenvalue = result.next_eigenvalue;
  report.residual = result.residual;
  report.iterations = result.iterations;
  report.normalized_vertices = static_cast<int>(m_weights.sum());
  return std::move(result.vector);
}

Eigen::VectorXcd internal::Least_energy_map::find(const Hermitian_sparse_matrix<Complex>& energy,
                                                  const internal::Subspace_options& options,
                                                  Parameterization_report& report) const
{
  internal::Solver_ref<Complex> solver = m_solvers.solver<Complex>();
  internal::Stopwatch watch;
  check("analysis", solver.analyze_with_positions(energy.pattern(), m_mesh.positions()));
  report.seconds.setup = watch.lap();
  const internal::Centered_mass<Complex> mass(m_weights,
                                              Eigen::MatrixXcd::Ones(m_weights.size(), 1));
  return eigenvector(energy, solver, mass, m_weights, m_start, options, report);
}

Eigen::VectorXcd internal::Least_energy_map::find(const Hermitian_sparse_matrix<double>& energy,
                                                  const internal::Subspace_options& options,
                                                  Parameterization_report& report) const
{
  const Eigen::Index n = m_weights.size(), k = m_start.cols();
  internal::Solver_ref<double> solver = m_solvers.solver<double>();
  internal::Stopwatch watch;
  const internal::Ordering order = amd_ordering(*vertex_graph(m_mesh));
  check("analysis", solver.analyze(energy.pattern(), expanded_ordering(order, 2)));
  report.seconds.setup = watch.lap();
  Eigen::VectorXd weights(2 * n);
  weights << m_weights, m_weights;
  weights = interleaved(weights);
  Eigen::MatrixXd start(2 * n, 2 * k), constants = Eigen::MatrixXd::Zero(2 * n, 2);
  start << m_start.real(), -m_start.imag(), m_start.imag(), m_start.real();
  constants.topLeftCorner(n, 1).setOnes();
  constants.bottomRightCorner(n, 1).setOnes();
  const internal::Centered_mass<double> mass(weights, interleaved(constants));
  const Eigen::VectorXd ab =
      eigenvector(energy, solver, mass, weights, interleaved(start), options, report);
  return Eigen::Map<const Eigen::VectorXcd>(reinterpret_cast<const Complex*>(ab.data()), n);
}

Eigen::MatrixXd internal::Least_energy_map::interleaved(const Eigen::MatrixXd& x)
{
  const Eigen::Index n = x.rows() / 2;
  Eigen::MatrixXd y(x.rows(), x.cols());
  for (Eigen::Index i = 0; i < n; ++i) {
    y.row(2 * i) = x.row(i);
    y.row(2 * i + 1) = x.row(n + i);
  }
  return y;
}

void internal::Least_energy_map::check(const char* step, Solver_status status) const
{
  if (status != Solver_status::success)
    throw Solver_error(m_function,
                       std::string(step) + " of the conformal energy failed: " + to_string(status));
}

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
  if (report.converged)
    report.overlap = overlap_summary(overlaps(mesh, positions), mesh, positions);
}

/// against the energy, which is dimensionless: the sides of a seam differ by its inverse
const double seam_stiffness = 1e5;

Eigen::VectorXcd least_energy_map(const Mesh_view& mesh, const std::vector<Vertex_loop>& loops,
                                  const Parameterization_options& options,
                                  Parameterization_report& report, const std::string& function)
{
  const Subspace_options subspace{options.tolerance, options.maximum_number_of_iterations};
  const auto graph = vertex_graph(mesh);
  Stopwatch watch;
  if (options.normals == Parameterization_options::Normals::of_faces) {
    auto energy = conformal_energy(mesh, graph_with_seams(mesh, options.seams));
    add_seams(options.seams, seam_stiffness, energy);
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
