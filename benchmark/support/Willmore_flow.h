// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef BENCHMARK_SUPPORT_WILLMORE_FLOW_H
#define BENCHMARK_SUPPORT_WILLMORE_FLOW_H

#include <Conformal_geometry_processing/linear_algebra/krylov/Lagged_solver.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <utility>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

template <class Solver>
const Solver& factor_of(const Solver& solver)
{
  return solver;
}
template <class Solver>
const Solver& factor_of(const CGP::internal::Lagged_solver<Solver>& solver)
{
  return solver.factor();
}

/// iterations of the last solve; none where it was direct
template <class Solver>
int iterations_of(const Solver&)
{
  return 0;
}
template <class Solver>
int iterations_of(const CGP::internal::Lagged_solver<Solver>& solver)
{
  return solver.iterations();
}

/// Returns how many of `steps` matrices were factorized
template <class Solver>
int factorizations_of(const Solver&, int steps)
{
  return steps;
}
template <class Solver>
int factorizations_of(const CGP::internal::Lagged_solver<Solver>& solver, int)
{
  return solver.factorizations();
}

/// Willmore flow, rho = -tau H on the vertices: the loop that flows consist of
template <class SolverTraits>
class Willmore_flow {
 public:
  explicit Willmore_flow(const CGP::Mesh_view& mesh) : m_mesh(mesh), m_transformation(mesh) {}

  /// curvature, matrices, factors or their reuse, eigenvector, positions and certificate
  CGP::Spin_report step(double tau, const CGP::Dirac_options& options = {})
  {
    if (m_steps++ > 0) m_transformation.set_positions(m_mesh.positions());
    CGP::Spin_result result = m_transformation.transform(
        CGP::Curvature_potential::on_vertices(-tau * CGP::mean_curvature(m_mesh)), options);
    m_mesh.set_positions(std::move(result.positions));
    return result.report;
  }

  /// number of steps, the last one included
  int steps() const { return m_steps; }
  const auto& eigensolver() const { return m_transformation.system().solver(); }
  const auto& poisson_solver() { return m_transformation.reconstruction().solver().solver(); }

 private:
  CGP::Mesh_view m_mesh;
  CGP::Spin_transformation<SolverTraits> m_transformation;
  int m_steps = 0;
};

}  // namespace cgp_benchmark

#endif
