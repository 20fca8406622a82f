// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Curvature_filter.h>

#include <Conformal_geometry_processing/measure/Realised_curvature.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

internal::Curvature_filter::Curvature_filter(const Surface_ref& surface, double weight, int order,
                                             const Spin_solvers& solvers)
    : Curvature_filter(surface, weight, order, vertex_graph(surface), solvers.solver<double>())
{
  check("analysis", m_solver.analyze(m_L.pattern()));
  update_geometry();
}

void internal::Curvature_filter::update_geometry()
{
  if (m_order == 0) return;
  const Eigen::VectorXd areas = vertex_areas(m_surface);
  const double radius_squared = areas.sum() / (4 * 3.14159265358979323846);
  m_masses = areas / (std::pow(m_weight, 1. / m_order) * radius_squared);
  assemble_cotan_laplacian(m_surface, cotan_weights(m_surface), m_L);
  check("factorization", m_solver.factorize(m_L, m_masses));
}

Eigen::VectorXd internal::Curvature_filter::operator()(const Eigen::VectorXd& v) const
{
  if (m_order == 0) return m_weight / (1 + m_weight) * v;
  // The recurrence of the Chebyshev polynomials in 2C - 1, whose spectrum is in [-1, 1].
  Eigen::VectorXd before = v, now = 2 * smoothed(v) - v;
  Eigen::VectorXd sum = m_series[0] * before + m_series[1] * now;
  for (Eigen::Index j = 2; j < m_series.size(); ++j) {
    before = 4 * smoothed(now) - 2 * now - before;
    now.swap(before);
    sum += m_series[j] * now;
  }
  return sum;
}

internal::Curvature_filter::Curvature_filter(const Surface_ref& surface, double weight, int order,
                                             std::shared_ptr<const Sparse_pattern> pattern,
                                             internal::Solver_ref<double>&& solver)
    : m_surface(surface),
      m_weight(weight),
      m_order(order),
      m_L(std::move(pattern)),
      m_solver(std::move(solver))
{
  if (!(weight > 0) || !std::isfinite(weight))
    throw Precondition_error("Curvature_filter", "a weight of " + std::to_string(weight) +
                                                     "; a positive number is needed");
  if (order < 0)
    throw Precondition_error(
        "Curvature_filter", "an order of " + std::to_string(order) + "; 0, 1, 2, ... are possible");
  if (order > 0) m_series = gain_series(order);
}

Eigen::VectorXd internal::Curvature_filter::smoothed(const Eigen::VectorXd& v) const
{
  Block<double> x;
  check("solution", m_solver.solve(m_masses.cwiseProduct(v), x));
  return x;
}

Eigen::VectorXd internal::Curvature_filter::gain_series(int k)
{
  const double pi = 3.14159265358979323846, precision = 1e-10;
  const double pole = k == 1 ? HUGE_VAL : std::tan(pi / (2 * k));
  const double decay = std::log(pole + std::hypot(1, pole));
  const int degree = (std::max)(1, static_cast<int>(std::ceil(-std::log(precision) / decay)));
  const int n = degree + 1;
  Eigen::VectorXd series = Eigen::VectorXd::Zero(n);
  for (int m = 0; m < n; ++m) {
    const double angle = pi * (m + .5) / n, c = (1 + std::cos(angle)) / 2;
    const double gain = 1 / (1 + std::pow(c / (1 - c), k));
    for (int j = 0; j < n; ++j) series[j] += (j == 0 ? 1. : 2.) / n * gain * std::cos(j * angle);
  }
  return series;
}

void internal::Curvature_filter::check(const char* step, Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("Curvature_filter",
                       std::string(step) + " of the smoothing matrix failed: " + to_string(status));
}

namespace internal {

Face_filter::Face_filter(const Mesh_view& input, const Spin_solvers& solvers)
    : m_solver(solvers.solver<double>())
{
  const Eigen::VectorXd areas = vertex_areas(input);
  m_masses = areas / areas.mean();
  const Hermitian_sparse_matrix<double> L = cotan_laplacian(input);
  check_smoothing("analysis", m_solver.analyze(L.pattern()));
  check_smoothing("factorization", m_solver.factorize(L, m_masses));
}

Points Face_filter::averaged(const Points& positions) const
{
  Block<double> smooth;
  const Block<double> b = m_masses.asDiagonal() * positions.transpose();
  check_smoothing("solution", m_solver.solve(b, smooth));
  return smooth.transpose();
}

Points Face_filter::settled(const Points& positions) const
{
  return averaged(2 * positions - averaged(positions));
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
