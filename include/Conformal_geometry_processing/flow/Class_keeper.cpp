// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Class_keeper.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <algorithm>
#include <cstddef>

namespace Conformal_geometry_processing {
namespace internal {

inline void require_fairing(Solver_status status)
{
  if (status != Solver_status::success) throw Solver_error("fairing", to_string(status));
}

}  // namespace internal

internal::Fairing::Fairing(const Mesh_view& initial, std::vector<char> is_held)
    : m_is_held(std::move(is_held)),
      m_laplacian(cotan_laplacian(initial)),
      m_matrix(m_laplacian),
      m_areas(vertex_areas(initial))
{
  require_fairing(m_solver.analyze_with_positions(m_laplacian.pattern(), initial.positions()));
}

Points internal::Fairing::operator()(const Mesh_view& mesh, double strength)
{
  const auto is_held = [this](int v) { return m_is_held[static_cast<std::size_t>(v)] != 0; };
  const Eigen::VectorXd mass = m_areas.cwiseProduct(vertex_areas(mesh)).cwiseSqrt();
  const double s = strength * mass.mean();
  int k = 0;
  m_laplacian.for_each_entry(
      [&](int i, int j, double a) { m_matrix.value(k++) = is_held(i) || is_held(j) ? 0 : s * a; });
  require_fairing(m_solver.factorize(m_matrix, mass));
  const Block<double> f = mesh.positions().transpose();
  return (f - rough_part(rough_part(f, s), s)).transpose();
}

// 1 - A = (M + s L)^-1 s L.
Block<double> internal::Fairing::rough_part(const Block<double>& f, double s) const
{
  Block<double> b(f.rows(), f.cols()), x;
  for (Eigen::Index c = 0; c < f.cols(); ++c) b.col(c) = s * (m_laplacian * f.col(c));
  for (Eigen::Index v = 0; v < b.rows(); ++v)
    if (m_is_held[static_cast<std::size_t>(v)]) b.row(v).setZero();
  require_fairing(m_solver.solve(b, x));
  return x;
}

namespace internal {

/// those at the boundary; where directions across it are kept, of the faces at the boundary
inline std::vector<char> held_vertices(const Mesh_view& mesh, const Boundary_condition& boundary)
{
  std::vector<char> is_held = boundary_vertices(mesh);
  const bool are_tangents = boundary.direction.tail<2>().isZero(0);
  if (boundary.kind != Boundary_condition::Kind::directions || are_tangents) return is_held;
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0)
      is_held[static_cast<std::size_t>(mesh.to(Mesh_view::next_in_face(h)))] = 1;
  return is_held;
}

}  // namespace internal

internal::Class_keeper::Class_keeper(const Mesh_view& initial, const Boundary_condition& boundary)
    : m_unit(Normalized_frame(initial.positions()).unit()),
      m_initial(initial.positions() / m_unit, initial.corners()),
      m_boundary(boundary),
      m_class(m_initial),
      m_fairing(m_initial, held_vertices(m_initial, boundary)),
      m_strength(1e6, 2.5e-3, 2, 2)
{}

void internal::Class_keeper::keep_directions(const Points& f)
{
  if (m_boundary.kind == Boundary_condition::Kind::directions)
    m_class.keep({Mesh_view(f, m_initial.corners()), m_boundary.direction});
}

bool internal::Class_keeper::snap(Points& f)
{
  keep_directions(f / m_unit);
  return snap_to_kept(f, true);
}

// Length cross-ratios sum four residuals. Energies are compared by
// `Flow_options::energy_tolerance`, 1e-4: what a surface gains within a wide band around the class
// would be taken for a descent, and the flow would not settle. Where limbs are thin, a few steps
// more do not lead into the narrow band. The factor of the last snap is kept: late in a flow its
// steps converge without another one. Of trials that come to the class from far away, nearly all
// have more energy then: they are refused before that, if another one follows.
bool internal::Class_keeper::snap_to_kept(Points& f, bool only_near)
{
  const double wide_band = 1e-3, narrow_band = 1e-5;
  Points moved = f / m_unit;
  Snap_options options;
  options.tolerance = narrow_band / 4;
  options.max_iterations = 17;
  options.keep_factor = true;
  options.sufficient = wide_band / 4;
  options.only_near = only_near;
  if (!m_class.snap(moved, options).converged) return false;
  take(std::move(moved), f);
  return true;
}

void internal::Class_keeper::polish(Points& f)
{
  Points moved = f / m_unit;
  keep_directions(moved);
  const Snap_report report = m_class.snap(moved);
  if (!(report.residual < report.initial_residual)) return;
  take(std::move(moved), f);
}

void internal::Class_keeper::take(Points moved, Points& f) const
{
  Quaternion_vector<double> no_spins;
  restore_area(m_initial, moved, no_spins);
  f = m_unit * moved;
}

std::optional<Points> internal::Class_keeper::smoothed(
    const Mesh_view& mesh, const std::function<bool(const Points&)>& is_better)
{
  const int trials = 3;
  Points f;
  for (int trial = 1; trial <= trials; ++trial) {
    if (try_smoothing(mesh, trial < trials, is_better, f)) {
      m_strength.grow();
      return f;
    }
    if (!m_strength.halve()) break;
    (void)m_strength.halve();
  }
  return std::nullopt;
}

void internal::Class_keeper::set_state(const State& state)
{
  m_strength = state.strength;
  m_class.set_state(state.snap);
}

bool internal::Class_keeper::try_smoothing(const Mesh_view& mesh, bool only_near,
                                           const std::function<bool(const Points&)>& is_better,
                                           Points& f)
{
  try {
    Mesh_view present = m_initial;
    present.set_positions(mesh.positions() / m_unit);
    keep_directions(present.positions());
    f = m_unit * m_fairing(present, m_strength.value());
    return snap_to_kept(f, only_near) && is_better(f);
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
    return false;
  }
}

}  // namespace Conformal_geometry_processing
