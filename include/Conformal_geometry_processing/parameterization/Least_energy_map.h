// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_LEAST_ENERGY_MAP_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_LEAST_ENERGY_MAP_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/linear_algebra/direct/amd_ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/expanded_graph.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/subspace_iteration.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/parameterization/Parameterization_report.h>
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>

#include <algorithm>
#include <complex>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief finds the map z = a + i b to the plane of least energy among those for which the sum of
/// |z - mean|^2 over the vertices of some loops is one.
///
/// Energies are complex matrices, |V| x |V|, where turning the image changes nothing, or else real
/// ones, 2|V| x 2|V|, in the order a_0, b_0, a_1, b_1, ...
template <class SolverTraits>
class Least_energy_map {
  using Complex = std::complex<double>;

 public:
  /// \param loops whose vertices are spread; the first one is not shorter than three edges
  Least_energy_map(const Mesh_view& mesh, const std::vector<Vertex_loop>& loops,
                   std::string function)
      : m_mesh(mesh),
        m_start(circle_maps(mesh, loops, (std::min)(4, static_cast<int>(loops[0].size()) - 1))),
        m_weights(Eigen::VectorXd::Zero(mesh.size_of_vertices())),
        m_function(std::move(function))
  {
    for (const Vertex_loop& loop : loops)
      for (const int v : loop) m_weights[v] = 1;
  }

  /// \param report receives what the eigenvector tells, and the seconds
  /// \throw Solver_error if a factorization fails
  Eigen::VectorXcd find(const Hermitian_sparse_matrix<Complex>& energy,
                        const Subspace_options& options, Parameterization_report& report) const
  {
    typename SolverTraits::template Solver<Complex> solver;
    Stopwatch watch;
    check("analysis", solver.analyze_with_positions(energy.pattern(), m_mesh.positions()));
    report.seconds.setup = watch.lap();
    const Centered_mass<Complex> mass(m_weights, Eigen::MatrixXcd::Ones(m_weights.size(), 1));
    return eigenvector(energy, solver, mass, m_weights, m_start, options, report);
  }

  Eigen::VectorXcd find(const Hermitian_sparse_matrix<double>& energy,
                        const Subspace_options& options, Parameterization_report& report) const
  {
    const Eigen::Index n = m_weights.size(), k = m_start.cols();
    typename SolverTraits::template Solver<double> solver;
    Stopwatch watch;
    const Ordering order = amd_ordering(*vertex_graph(m_mesh));
    check("analysis", solver.analyze(energy.pattern(), expanded_ordering(order, 2)));
    report.seconds.setup = watch.lap();
    Eigen::VectorXd weights(2 * n);
    weights << m_weights, m_weights;
    weights = interleaved(weights);
    Eigen::MatrixXd start(2 * n, 2 * k), constants = Eigen::MatrixXd::Zero(2 * n, 2);
    start << m_start.real(), -m_start.imag(), m_start.imag(), m_start.real();
    constants.topLeftCorner(n, 1).setOnes();
    constants.bottomRightCorner(n, 1).setOnes();
    const Centered_mass<double> mass(weights, interleaved(constants));
    const Eigen::VectorXd ab =
        eigenvector(energy, solver, mass, weights, interleaved(start), options, report);
    return Eigen::Map<const Eigen::VectorXcd>(reinterpret_cast<const Complex*>(ab.data()), n);
  }

 private:
  /// rows 0 ... n-1, n ... 2n-1 in the order 0, n, 1, n+1, ...
  static Eigen::MatrixXd interleaved(const Eigen::MatrixXd& x)
  {
    const Eigen::Index n = x.rows() / 2;
    Eigen::MatrixXd y(x.rows(), x.cols());
    for (Eigen::Index i = 0; i < n; ++i) {
      y.row(2 * i) = x.row(i);
      y.row(2 * i + 1) = x.row(n + i);
    }
    return y;
  }

  template <class Scalar, class Solver>
  Vector<Scalar> eigenvector(const Hermitian_sparse_matrix<Scalar>& energy, Solver& solver,
                             const Centered_mass<Scalar>& mass, const Eigen::VectorXd& weights,
                             const Block<Scalar>& start, const Subspace_options& options,
                             Parameterization_report& report) const
  {
    Stopwatch watch;
    const double shift = factorize(energy, weights, solver);
    report.seconds.factorization = watch.lap();
    Subspace_result<Scalar> result =
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

  /// The energy is zero for constants, so its factor is that of energy + shift weights. Constants
  /// have the energy `constant` then, far below that of all maps but those of flat surfaces; it has
  /// to be larger than what rounding makes of zero, which meshes with slivers show.
  template <class Scalar, class Solver>
  double factorize(const Hermitian_sparse_matrix<Scalar>& energy, const Eigen::VectorXd& weights,
                   Solver& solver) const
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

  void check(const char* step, Solver_status status) const
  {
    if (status != Solver_status::success)
      throw Solver_error(
          m_function, std::string(step) + " of the conformal energy failed: " + to_string(status));
  }

  const Mesh_view& m_mesh;
  Eigen::MatrixXcd m_start;   // |V| x up to 4
  Eigen::VectorXd m_weights;  // |V|: 1 on the loops
  std::string m_function;
};

}  // namespace Conformal_geometry_processing

#endif
