// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Class_fairing.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

// The weight of the constraints against K. The class is reached by steps with one factor, each of
// which leaves about 1 / weight of the residuals; a larger one costs digits.
constexpr double relative_class_weight = 5e7;
constexpr double class_scale_weight = 1e-6;  // of |du|^2, so that the matrix is definite
// Of the logarithms of lengths: what is aimed at, and what is enough for a step, for errors of
// steps do not add up. On isothermic surfaces, such as spheres, the last digits converge slowly.
constexpr double class_residual = 2.5e-11, largest_class_residual = 1e-7, slow = .9;
constexpr int most_steps_to_class = 20;
constexpr double least_step = 1e-4;

}  // namespace internal

internal::Class_fairing::Class_fairing(const Fairing_patch& patch)
    : m_patch(patch),
      m_bending(patch),
      m_form(Edge_scales(patch.mesh(), patch.unknowns()), *m_bending.pattern()),
      m_scales(Eigen::VectorXd::Zero(patch.size()))
{
  const Points& f = patch.mesh().positions();
  require_fairing_solver(m_form.analyze(m_solver, f(Eigen::indexing::all, patch.free_vertices())));
}

void internal::Class_fairing::factorize(const Bending_energy& energy)
{
  const Sparse_pattern& pattern = *m_bending.pattern();
  Eigen::VectorXd K = Eigen::VectorXd::Zero(pattern.size_of_entries());
  m_bending.assemble(energy, [&](int k, double x) { K[k] += x; });
  m_form.linearize(energy.mesh().positions());
  double trace = 0;
  for (int j = 0; j < pattern.size(); ++j) {
    const int first = pattern.offsets[static_cast<std::size_t>(j)];
    for (int k = first; k < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++k)
      m_form.add_of_positions(pattern.indices[static_cast<std::size_t>(k)], j, K[k]);
    m_form.add_of_scale(j, class_scale_weight);
    trace += 3 * K[first];
  }
  m_form.add_equations(relative_class_weight * trace / m_form.inverse_squared_lengths().sum());
  require_fairing_solver(factorize_definite(m_solver, m_form.matrix(), 1));
}

internal::Class_fairing::State internal::Class_fairing::state_at(Points f, Eigen::VectorXd u) const
{
  Eigen::VectorXd residuals = m_form.scales().residuals(f, u);
  return {std::move(f), std::move(u), std::move(residuals)};
}

internal::Class_fairing::State internal::Class_fairing::advanced(const State& state,
                                                                 const Points& g) const
{
  Block<double> b = m_form.right_hand_side(state.residuals), x;
  b.col(0).reshaped(4, m_patch.size()).topRows<3>() -= g;
  require_fairing_solver(m_solver.solve(b, x));
  const auto at_vertices = x.col(0).reshaped(4, m_patch.size());
  return state_at(moved(m_patch, state.f, at_vertices.topRows<3>()),
                  state.u + at_vertices.row(3).transpose());
}

bool internal::Class_fairing::return_to_class(State& state) const
{
  const auto distance = [](const State& s) { return s.residuals.lpNorm<Eigen::Infinity>(); };
  const Points none = Points::Zero(3, m_patch.size());
  for (int k = 0; k < most_steps_to_class && distance(state) > class_residual; ++k) {
    State next = advanced(state, none);
    if (!(distance(next) < slow * distance(state))) break;  // also if it is not a number
    state = std::move(next);
  }
  return distance(state) <= largest_class_residual;
}

internal::Fairing_step internal::Class_fairing::step(const Bending_energy& present)
{
  factorize(present);
  const Points g = present.gradient()(Eigen::indexing::all, m_patch.free_vertices());
  const State start = state_at(present.mesh().positions(), m_scales);
  Fairing_step next;
  for (m_length = (std::min)(1., 2 * m_length); m_length > least_step; m_length /= 2) {
    State state = advanced(start, m_length * g);
    next.is_lower =
        return_to_class(state) && Bending_energy(m_patch, state.f).value() < present.value();
    next.f = std::move(state.f);
    if (!next.is_lower) continue;
    m_scales = std::move(state.u);
    break;
  }
  return next;
}

void internal::Class_fairing::polish(Points& f)
{
  factorize(Bending_energy(m_patch, f));
  State state = state_at(f, m_scales);
  return_to_class(state);
  f = std::move(state.f);
}

}  // namespace Conformal_geometry_processing
