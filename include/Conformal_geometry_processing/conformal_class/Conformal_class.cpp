// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>

#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/QR>
#include <cmath>

namespace Conformal_geometry_processing {

void internal::Snap_history::forget()
{
  m_changes.resize(0, 0);
  m_changes_of_residuals.resize(0, 0);
}

void internal::Snap_history::add(const Snap_state& from, const Snap_state& to)
{
  const Eigen::Index most = 5;
  Eigen::VectorXd change(4 * from.u.size());
  change << (to.f - from.f).reshaped(), to.u - from.u;
  const auto append = [&](Eigen::MatrixXd& columns, const Eigen::VectorXd& column) {
    if (columns.cols() == most)
      columns.leftCols(most - 1) = columns.rightCols(most - 1).eval();
    else
      columns.conservativeResize(column.size(), columns.cols() + 1);
    columns.rightCols(1) = column;
  };
  append(m_changes, change);
  append(m_changes_of_residuals, to.residuals - from.residuals);
}

auto internal::Snap_history::extrapolated(Snap_state state) const -> Snap_state
{
  if (m_changes.cols() == 0) return state;
  const Eigen::VectorXd shares =
      m_changes_of_residuals.colPivHouseholderQr().solve(state.residuals);
  const Eigen::VectorXd change = m_changes * shares;
  state.f -= change.head(state.f.size()).reshaped(3, state.f.cols());
  state.u -= change.tail(state.u.size());
  state.residuals -= m_changes_of_residuals * shares;
  return state;
}

internal::Conformal_class::Conformal_class(const Mesh_view& mesh)
    : m_equations(mesh, *vertex_graph(mesh))
{}

void internal::Conformal_class::keep(Rim_directions rim)
{
  m_rim = std::move(rim);
  m_equations.keep(m_rim);
}

void internal::Conformal_class::keep(Global_equation equation)
{
  m_global = equation;
  m_equations.keep(std::move(equation));
}

Eigen::VectorXd internal::Conformal_class::residuals(const Points& f,
                                                     const Eigen::VectorXd& u) const
{
  const Eigen::VectorXd of_edges = m_equations.scales().residuals(f, u),
                        of_rim = m_rim.residuals(f);
  Eigen::VectorXd all(of_edges.size() + of_rim.size() + m_global.has_value());
  all.head(of_edges.size() + of_rim.size()) << of_edges, of_rim;
  if (m_global) all[all.size() - 1] = m_global->residual(f);
  return all;
}

bool internal::Conformal_class::advance(State& state, double factor, int halvings) const
{
  const Snap_state from = state.history.extrapolated(state);
  Points df;
  Eigen::VectorXd du;
  m_equations.solve(from.residuals, df, du);
  const double limit = factor * state.residuals.norm();
  for (double t = 1; halvings >= 0; t /= 2, --halvings) {
    Snap_state next{from.f + t * df, from.u + t * du, {}};
    next.residuals = residuals(next.f, next.u);
    if (!(next.residuals.norm() < limit)) continue;  // also if it is not a number
    state.history.add(state, next);
    static_cast<Snap_state&>(state) = std::move(next);
    return true;
  }
  return false;
}

// A factor costs about as much as a dozen steps, and has to lead there in half of those that are
// left: what is only near the class has an energy of its own.
double internal::Conformal_class::most_left(double residual, const Snap_options& options, int left)
{
  const int steps = (std::min)((left + 1) / 2, 12);
  const double slowest = .8;
  return (std::min)(std::pow(options.tolerance / residual, 1. / steps), slowest);
}

bool internal::Conformal_class::factorize(const Points& f, bool is_needed)
{
  try {
    m_equations.factorize(f);
    return true;
  } catch (const Solver_error& error) {
    if (is_needed || is_out_of_memory(error)) throw;
    return false;
  }
}

// Newton's method has a basin: outside of it, the first step takes little away.
bool internal::Conformal_class::iterate(State& state, const Snap_options& options, int left,
                                        Snap_report& report)
{
  const double outside = .37;  // a step outside of the basin leaves more of the residuals
  const double is_near = 1e-6, fast = .2;  // a factor that leaves more there is damped too much
  const bool is_new = !state.has_factor;
  if (is_new && report.residual < is_near &&
      report.residual < m_equations.scales().rounding(state.f))
    return false;
  if (is_new && !factorize(state.f, report.residual > options.enough())) return false;
  report.factorizations += is_new;
  ++report.iterations;
  const double norm = state.residuals.norm(), most = most_left(report.residual, options, left);
  if (is_new) state.history.forget();
  state.has_factor = is_new ? advance(state, 1, 8) : advance(state, most, 0);
  if (is_new && !state.has_factor && !m_equations.damp()) return false;
  const double before = std::exchange(report.residual, state.residuals.lpNorm<Eigen::Infinity>());
  if (!is_new) return true;
  const double rest = state.residuals.norm() / norm;
  if (options.only_near && rest > outside && report.residual > options.enough()) return false;
  state.has_factor = state.has_factor && rest < most;
  if (report.residual < is_near && report.residual > fast * before)
    m_equations.undamp(), state.has_factor = false;
  return true;
}

internal::Snap_report internal::Conformal_class::snap(Points& f, const Snap_options& options)
{
  const int few = 5;
  const double damping = m_equations.damping();
  State state;
  state.f = f;
  state.u = m_equations.scales().nearest_scales(f);
  state.residuals = residuals(f, state.u);
  Snap_report report;
  report.initial_residual = report.residual = state.residuals.lpNorm<Eigen::Infinity>();
  state.has_factor = options.keep_factor && m_equations.resume(f);
  for (int left = options.max_iterations; report.residual > options.tolerance && left > 0; --left) {
    if (report.residual <= options.enough()) left = (std::min)(left, few);
    if (!iterate(state, options, left, report)) break;
  }
  m_equations.set_damping((std::max)(damping, m_equations.damping()));
  report.converged = report.residual <= options.enough();
  f = std::move(state.f);
  return report;
}

}  // namespace Conformal_geometry_processing
