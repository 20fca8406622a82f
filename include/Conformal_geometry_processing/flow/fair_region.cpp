// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/fair_region.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

constexpr double least_share_of_relaxation = .125;

/// the vertices that stay
inline std::vector<int> held_vertices(const Fairing_patch& patch)
{
  std::vector<int> held;
  for (int v = 0; v < patch.mesh().size_of_vertices(); ++v)
    if (!patch.is_free(v)) held.push_back(v);
  return held;
}

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

internal::Outline_fairing::Outline_fairing(const Fairing_patch& patch)
    : m_patch(patch),
      m_bending(patch),
      m_start(patch.mesh().positions()),
      m_matrix(m_bending.pattern()),
      m_laplacian(vertex_graph(patch.mesh())),
      m_harmonic(m_laplacian.shared_pattern(), held_vertices(patch))
{
  require_fairing_solver(m_solver.analyze(m_matrix.pattern()));
  offer(patch.mesh().positions());
  offer(harmonic_with_unit_weights());
  const Mesh_view first(m_start, patch.mesh().corners());
  assemble_cotan_laplacian(first, cotan_weights(first), m_laplacian);
  m_harmonic.factorize(m_laplacian);
}

// A surface too degenerate for a factor is not a start.
void internal::Outline_fairing::offer(const Points& f)
{
  try {
    Points g = f;
    for (int k = 0; k < 2; ++k) g = biharmonic(Bending_energy(m_patch, g));
    if (Bending_energy(m_patch, g).value() < Bending_energy(m_patch, m_start).value())
      m_start = std::move(g);
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
  }
}

Points internal::Outline_fairing::harmonic_with_unit_weights() const
{
  const Mesh_view& mesh = m_patch.mesh();
  Hermitian_sparse_matrix<double> L(m_laplacian.shared_pattern());
  assemble_cotan_laplacian(mesh, Eigen::VectorXd::Ones(mesh.size_of_edges()), L);
  Dirichlet_solver<double> solver(m_laplacian.shared_pattern(), held_vertices(m_patch));
  solver.factorize(L);
  const Block<double> f = mesh.positions().transpose();
  return solver.solve(L, Block<double>::Zero(f.rows(), 3), f).transpose();
}

void internal::Outline_fairing::assemble(const Bending_energy& energy)
{
  m_matrix.set_zero();
  m_bending.assemble(energy, [this](int k, double x) { m_matrix.value(k) += x; });
}

// K f = 0 with all vertices, of which the held ones are the right-hand side: L A^-1 L of f without
// the free ones.
Points internal::Outline_fairing::biharmonic(const Bending_energy& energy)
{
  assemble(energy);
  require_fairing_solver(m_solver.factorize(m_matrix, {}));
  const Mesh_view& mesh = energy.mesh();
  Points f = mesh.positions();
  for (int k = 0; k < m_patch.size(); ++k) f.col(m_patch.free_vertex(k)).setZero();
  Hermitian_sparse_matrix<double> L(m_laplacian.shared_pattern());
  assemble_cotan_laplacian(mesh, energy.weights(), L);
  const auto laplacian = block_operator(L);
  Block<double> curvature = laplacian(f.transpose());
  for (int v = 0; v < f.cols(); ++v)
    curvature.row(v) *= m_patch.bends(v) ? -.5 / energy.areas()[v] : 0;
  const Block<double> force = laplacian(curvature);
  Block<double> b(m_patch.size(), 3), x;
  for (int k = 0; k < m_patch.size(); ++k) b.row(k) = force.row(m_patch.free_vertex(k));
  require_fairing_solver(m_solver.solve(b, x));
  return moved(m_patch, std::move(f), x.transpose());
}

Points internal::Outline_fairing::relaxation(const Bending_energy& energy) const
{
  const Points N = vertex_normals(energy.mesh());
  const Points& f = energy.mesh().positions();
  const auto tangential = [&](int v, const Eigen::Vector3d& d) -> Eigen::Vector3d {
    return d - N.col(v).dot(d) * N.col(v);
  };
  Block<double> b(f.cols(), 3);
  for (int c = 0; c < 3; ++c) b.col(c) = -(m_laplacian * f.row(c).transpose());
  for (int v = 0; v < f.cols(); ++v) b.row(v) = tangential(v, b.row(v).transpose()).transpose();
  const Block<double> d = m_harmonic.solve(m_laplacian, b, Block<double>::Zero(f.cols(), 3));
  Points way(3, m_patch.size());
  for (int k = 0; k < m_patch.size(); ++k) {
    const int v = m_patch.free_vertex(k);
    way.col(k) = tangential(v, d.row(v).transpose());
  }
  return way;
}

Points internal::Outline_fairing::descent(const Bending_energy& energy) const
{
  const Points N = vertex_normals(energy.mesh()), g = energy.gradient();
  Block<double> b(m_patch.size(), 1), phi;
  for (int k = 0; k < m_patch.size(); ++k) {
    const int v = m_patch.free_vertex(k);
    b(k, 0) = -N.col(v).dot(g.col(v));
  }
  require_fairing_solver(m_solver.solve(b, phi));
  Points d(3, m_patch.size());
  for (int k = 0; k < m_patch.size(); ++k) d.col(k) = phi(k, 0) * N.col(m_patch.free_vertex(k));
  return d;
}

internal::Fairing_step internal::Outline_fairing::step(const Bending_energy& present)
{
  const Points way = relaxation(present);
  m_share = (std::min)(1., (std::max)(2 * m_share, least_share_of_relaxation));
  for (; m_share >= least_share_of_relaxation; m_share /= 2) {
    const Points relaxed = moved(m_patch, present.mesh().positions(), way, m_share);
    try {
      Fairing_step next = descend_from(relaxed, present, 2);
      if (next.is_lower) return next;
    } catch (const Solver_error& error) {
      if (is_out_of_memory(error)) throw;  // otherwise the relaxed surface is too degenerate
    }
  }
  m_share = 0;
  return descend_from(present.mesh().positions(), present, 12);
}

internal::Fairing_step internal::Outline_fairing::descend_from(const Points& relaxed,
                                                               const Bending_energy& present,
                                                               int halvings)
{
  const Bending_energy energy(m_patch, relaxed);
  assemble(energy);
  require_fairing_solver(factorize_definite(m_solver, m_matrix, 1));
  const Points d = descent(energy);
  Fairing_step next;
  for (double t = 1; halvings >= 0 && !next.is_lower; t /= 2, --halvings) {
    next.f = moved(m_patch, relaxed, d, t);
    next.is_lower = Bending_energy(m_patch, next.f).value() < present.value();
  }
  return next;
}

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

namespace internal {

/// why there is no step: a surface that was good before is not lost
template <class Step>
std::string step_fault(const Step& step)
{
  try {
    step();
    return "";
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
    return "no further step: " + error.message();
  }
}

/// takes steps from f until they are short
template <class Fairing>
void take_steps(const Fairing_patch& patch, Fairing& fairing, const Fairing_options& options,
                const std::function<bool()>& go_further, Points& f, Fairing_report& report)
{
  const Points& p = patch.mesh().positions();
  const double diagonal = (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
  report.message = "no step was asked for";
  for (int k = 0; k < options.max_steps; ++k) {
    if (!go_further()) {
      report.message = "cancelled";
      return;
    }
    Fairing_step next{f};
    report.message = step_fault([&] { next = fairing.step(Bending_energy(patch, f)); });
    if (!report.message.empty()) return;
    const double way = (next.f - f).colwise().norm().maxCoeff();
    report.converged = way <= options.tolerance * diagonal;
    if (next.is_lower) f = std::move(next.f), ++report.steps;
    if (report.converged) return;
    report.message = next.is_lower ? "all steps are done" : "no step lowers the energy";
    if (!next.is_lower) return;
  }
}

/// of the faces that move
inline Conformality map_of_region(const Fairing_patch& patch, const Points& f)
{
  std::vector<char> moves;
  for (int k = 0; k < patch.mesh().size_of_faces(); ++k) moves.push_back(patch.moves(k));
  const Mesh_component part = selected_faces(patch.mesh(), moves);
  const Points after = f(Eigen::indexing::all, part.vertices);
  return conformality(part.mesh, after, neighbourhood_normals(part.mesh, after));
}

}  // namespace internal

internal::Fairing_result internal::fair_region(const Mesh_view& mesh,
                                               const std::vector<char>& is_in_region,
                                               const Fairing_options& options,
                                               const std::string& function,
                                               const std::function<bool()>& go_further)
{
  require_not_empty(mesh, function);
  require_finite_positions(mesh, function);
  require_distinct_corners(mesh, function);
  require_manifold_edges(mesh, function);
  require_manifold_vertices(mesh, function);
  const Normalized_frame frame(mesh.positions());
  const Mesh_view framed(frame.to_frame(mesh.positions()), mesh.corners());
  const Fairing_patch patch(framed, is_in_region, function);
  Fairing_report report;
  report.free_vertices = patch.size();
  Points f = patch.mesh().positions();
  report.initial_energy = Bending_energy(patch, f).value();
  report.initial_normal_jump = normal_jump(patch, f);
  if (options.exact_conformal_class) {
    Class_fairing fairing(patch);
    take_steps(patch, fairing, options, go_further, f, report);
    const std::string fault = report.steps > 0 ? step_fault([&] { fairing.polish(f); }) : "";
    if (!fault.empty()) report.converged = false, report.message = fault;
  } else {
    Outline_fairing fairing(patch);
    f = fairing.start();
    take_steps(patch, fairing, options, go_further, f, report);
  }
  const Points moved = frame.from_frame(f);
  Points positions = mesh.positions();
  for (int k = 0; k < patch.size(); ++k) {
    const int v = patch.free_vertex(k);
    positions.col(patch.vertices()[static_cast<std::size_t>(v)]) = moved.col(v);
  }
  report.energy = Bending_energy(patch, f).value();
  report.normal_jump = normal_jump(patch, f);
  report.conformality = map_of_region(patch, f);
  return {std::move(positions), std::move(report)};
}

}  // namespace Conformal_geometry_processing
