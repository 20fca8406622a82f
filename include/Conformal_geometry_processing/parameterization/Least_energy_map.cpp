// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/Least_energy_map.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/linear_algebra/direct/expanded_graph.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

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

}  // namespace Conformal_geometry_processing
