// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CONFORMAL_CLASS_CONFORMAL_CLASS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_CONFORMAL_CLASS_CONFORMAL_CLASS_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

#include <algorithm>
#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

CGP_INLINE internal::Conformal_class::Conformal_class(const Mesh_view& mesh)
    : Conformal_class(mesh, vertex_graph(mesh))
{}

CGP_INLINE internal::Conformal_class::Conformal_class(
    const Mesh_view& mesh, const std::shared_ptr<const Sparse_pattern>& graph)
    : m_scales(mesh, graph), m_equations(mesh, *graph)
{}

CGP_INLINE void internal::Conformal_class::keep(Rim_directions rim)
{
  m_rim = std::move(rim);
  m_equations.keep(m_rim);
}

CGP_INLINE Eigen::VectorXd internal::Conformal_class::residuals(const Points& f,
                                                                const Eigen::VectorXd& u) const
{
  const Eigen::VectorXd of_edges = m_scales.residuals(f, u), of_rim = m_rim.residuals(f);
  Eigen::VectorXd all(of_edges.size() + of_rim.size());
  all << of_edges, of_rim;
  return all;
}

CGP_INLINE bool internal::Conformal_class::advance(State& state, double factor, int halvings) const
{
  Points df;
  Eigen::VectorXd du;
  m_equations.solve(state.residuals, df, du);
  const double limit = factor * state.residuals.norm();
  for (double t = 1; halvings >= 0; t /= 2, --halvings) {
    State next{state.f + t * df, state.u + t * du, {}};
    next.residuals = residuals(next.f, next.u);
    if (!(next.residuals.norm() < limit)) continue;  // also if it is not a number
    state = std::move(next);
    return true;
  }
  return false;
}

CGP_INLINE internal::Snap_report internal::Conformal_class::snap(Points& f,
                                                                 const Snap_options& options)
{
  const double fast = .2;       // a step with an old factor has to gain so much
  const double is_near = 1e-6;  // a new factor that gains less there is damped too much
  const double damping = m_equations.damping();
  State state{f, m_scales.nearest_scales(f), {}};
  state.residuals = residuals(f, state.u);
  Snap_report report;
  report.initial_residual = report.residual = state.residuals.lpNorm<Eigen::Infinity>();
  bool has_factor = options.keep_factor && m_equations.resume();
  while (report.residual > options.tolerance && report.iterations < options.max_iterations) {
    const bool is_new = !has_factor;
    if (is_new && report.residual < is_near && report.residual < m_scales.rounding(state.f)) break;
    if (is_new) m_equations.factorize(state.f), ++report.factorizations;
    ++report.iterations;
    has_factor = is_new ? advance(state, 1, 8) : advance(state, fast, 0);
    if (is_new && !has_factor && !m_equations.damp()) break;
    const double before = std::exchange(report.residual, state.residuals.lpNorm<Eigen::Infinity>());
    if (is_new && report.residual < is_near && report.residual > fast * before)
      m_equations.undamp(), has_factor = false;
  }
  m_equations.set_damping((std::max)(damping, m_equations.damping()));
  report.converged = report.residual <= options.tolerance;
  f = std::move(state.f);
  return report;
}

}  // namespace Conformal_geometry_processing

#endif
