// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Snap_equations.h>

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace Conformal_geometry_processing {
namespace internal {

/// The frame (T, N, B) of a face at its first edge, and the place of the third vertex in it
struct Rim_frame {
  Rim_frame(const Points& f, const std::array<int, 3>& face)
  {
    const Eigen::Vector3d e = f.col(face[1]) - f.col(face[0]), g = f.col(face[2]) - f.col(face[0]);
    length = e.norm();
    const Eigen::Vector3d T = e / length, N = e.cross(g).normalized(), B = T.cross(N);
    axes << T, N, B;
    foot = g.dot(T) / length;
    height = -g.dot(B);
  }

  Eigen::Matrix3d axes;  // in columns
  double length, foot;   // of the edge; the foot of the third vertex on it, by its length
  double height;         // of the third vertex above the edge
};

constexpr double snap_scale_weight = .01;  // of |du|^2 in G
constexpr double largest_snap_eps = 1e-3, smallest_snap_eps = 1e-11;

inline void require_snap(Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("snap to the conformal class", to_string(status));
}

}  // namespace internal

internal::Rim_directions::Rim_directions(const Mesh_view& mesh, const Eigen::Vector3d& direction)
    : m_direction(direction.normalized())
{
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0)
      m_faces.push_back({mesh.from(h), mesh.to(h), mesh.to(Mesh_view::next_in_face(h))});
  m_normals.resize(3, static_cast<Eigen::Index>(m_faces.size()));
  m_others.resizeLike(m_normals);
  for (Eigen::Index k = 0; k < m_normals.cols(); ++k) {
    const Rim_frame frame(mesh.positions(), m_faces[static_cast<std::size_t>(k)]);
    const Eigen::Vector3d U = frame.axes * m_direction;
    m_normals.col(k) = U.unitOrthogonal();
    m_others.col(k) = U.cross(m_normals.col(k));
  }
}

Eigen::VectorXd internal::Rim_directions::residuals(const Points& f) const
{
  Eigen::VectorXd r(size_of_rows());
  for (Eigen::Index k = 0; k < m_normals.cols(); ++k) {
    const Rim_frame frame(f, m_faces[static_cast<std::size_t>(k)]);
    const Eigen::Vector3d U = frame.axes * m_direction;
    r[2 * k] = U.dot(m_normals.col(k));
    r[2 * k + 1] = U.dot(m_others.col(k));
  }
  return r;
}

// The frame turns about N and B as the edge does, by a_B and a_N over its length, and about T as
// the third vertex rises from the line of the edge, by w over its height:
// dU = t (a_N N + a_B B) + n (w B - a_N T) - b (w N + a_B T).
std::vector<internal::Rim_directions::Row> internal::Rim_directions::derivative(
    const Points& f) const
{
  std::vector<Row> rows;
  for (Eigen::Index k = 0; k < m_normals.cols(); ++k) {
    const std::array<int, 3>& face = m_faces[static_cast<std::size_t>(k)];
    const Rim_frame frame(f, face);
    const Eigen::Vector3d T = frame.axes.col(0), N = frame.axes.col(1), B = frame.axes.col(2);
    const double t = m_direction[0], n = m_direction[1], b = m_direction[2];
    for (const Eigen::Vector3d p : {m_normals.col(k), m_others.col(k)}) {
      const double of_a_N = t * N.dot(p) - n * T.dot(p), of_a_B = t * B.dot(p) - b * T.dot(p);
      const double of_w = n * B.dot(p) - b * N.dot(p);
      const Eigen::Vector3d turn = (of_a_N * N + of_a_B * B) / frame.length,
                            rise = of_w / frame.height * N;
      Row row{face, {}};
      row.gradients << -turn - (1 - frame.foot) * rise, turn - frame.foot * rise, rise;
      rows.push_back(row);
    }
  }
  return rows;
}

internal::Snap_equations::Snap_equations(const Mesh_view& mesh, const Sparse_pattern& graph)
    : m_components(connected_components(mesh)), m_form(Edge_scales(mesh), graph)
{
  require_snap(m_form.analyze(m_solver, mesh.positions()));
}

void internal::Snap_equations::keep(Rim_directions rim)
{
  if (m_state.last && rim.size_of_rows() != m_state.last->rim.size_of_rows())
    m_state.last = nullptr;
  m_rim = std::move(rim);
}

void internal::Snap_equations::keep(Global_equation equation)
{
  if (!m_global) m_state.last = m_factorized = nullptr;
  m_global = std::move(equation);
}

bool internal::Snap_equations::damp()
{
  if (m_state.eps >= largest_snap_eps) return false;
  m_state.eps *= 10;
  return true;
}

void internal::Snap_equations::undamp()
{
  m_state.eps = (std::max)(m_state.eps / 10, smallest_snap_eps);
}

void internal::Snap_equations::factorize(const Points& f)
{
  m_state.last = nullptr;
  Linearization at{f, m_rim, m_state.eps};
  Solver_status status = factorize(at);
  while (status == Solver_status::not_positive_definite && damp()) {
    at.eps = m_state.eps;
    status = factorize(at);
  }
  require_snap(status);
  m_state.last = m_factorized = std::make_shared<const Linearization>(std::move(at));
}

bool internal::Snap_equations::resume(const Points& f)
{
  if (!m_state.last || !serves(*m_state.last, f)) return false;
  if (m_state.last != m_factorized) {
    require_snap(factorize(*m_state.last));
    m_factorized = m_state.last;
  }
  return true;
}

bool internal::Snap_equations::serves(const Linearization& at, const Points& f) const
{
  const double largest = .2;  // root mean square
  double squares = 0;
  for (const Edge_scales::Edge& edge : scales().edges()) {
    const auto [i, j] = edge.ends;
    const Eigen::Vector3d before = at.f.col(j) - at.f.col(i), after = f.col(j) - f.col(i);
    squares += (after - before).squaredNorm() / before.squaredNorm();
  }
  return squares < largest * largest * static_cast<double>(scales().edges().size());
}

Solver_status internal::Snap_equations::factorize(const Linearization& at)
{
  m_factorized = nullptr;
  assemble(at);
  const double most = 1e-8;  // beyond, it is more damping that helps
  const Solver_status status = factorize_definite(m_solver, m_form.matrix(), most);
  if (m_global && status == Solver_status::success) solve_global(m_global->gradient(at.f));
  return status;
}

void internal::Snap_equations::solve_global(const Points& gradient)
{
  Eigen::Matrix4Xd g = Eigen::Matrix4Xd::Zero(4, gradient.cols());
  g.topRows<3>() = gradient;
  m_global_gradient = g.reshaped();
  require_snap(m_solver.solve(m_global_gradient, m_global_response));
}

void internal::Snap_equations::assemble(const Linearization& at)
{
  m_form.linearize(at.f);
  m_form.add_equations(1);
  m_rim_rows = at.rim.derivative(at.f);
  for (const Rim_directions::Row& row : m_rim_rows) add_rim_row(row);
  const Eigen::VectorXd of_edges = m_form.inverse_squared_lengths();
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(at.f.cols());  // of the positions in G
  for (std::size_t k = 0; k < scales().edges().size(); ++k) {
    const auto [i, j] = scales().edges()[k].ends;
    const double weight = of_edges[static_cast<Eigen::Index>(k)];
    m_form.add_of_positions(j, i, -at.eps * weight);
    weights[i] += weight, weights[j] += weight;
  }
  int components = 0;
  for (int v = 0; v < at.f.cols(); ++v) {
    const bool is_held = m_components[static_cast<std::size_t>(v)] == components;
    components += is_held;
    m_form.add_of_positions(v, v, (is_held + at.eps) * weights[v]);
    m_form.add_of_scale(v, at.eps * snap_scale_weight);
  }
}

void internal::Snap_equations::add_rim_row(const Rim_directions::Row& row)
{
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const int i = row.vertices[static_cast<std::size_t>(a)],
                j = row.vertices[static_cast<std::size_t>(b)];
      if (i < j) continue;
      Eigen::Matrix4d block = Eigen::Matrix4d::Zero();
      block.topLeftCorner<3, 3>() = row.gradients.col(a) * row.gradients.col(b).transpose();
      m_form.add(i, j, block);
    }
}

void internal::Snap_equations::solve(const Eigen::VectorXd& c, Points& df,
                                     Eigen::VectorXd& du) const
{
  const auto edges = static_cast<Eigen::Index>(scales().edges().size());
  Block<double> b = m_form.right_hand_side(c.head(edges)), d;
  for (std::size_t k = 0; k < m_rim_rows.size(); ++k)
    for (int v = 0; v < 3; ++v)
      b.block<3, 1>(4 * m_rim_rows[k].vertices[static_cast<std::size_t>(v)], 0) -=
          c[edges + static_cast<Eigen::Index>(k)] * m_rim_rows[k].gradients.col(v);
  require_snap(m_solver.solve(b, d));
  if (m_global) {
    const double rest = c[c.size() - 1] + m_global_gradient.col(0).dot(d.col(0));
    d -= rest / m_global_gradient.col(0).dot(m_global_response.col(0)) * m_global_response;
  }
  const auto at_vertices = d.col(0).reshaped(4, d.rows() / 4);
  df = at_vertices.topRows<3>();
  du = at_vertices.row(3);
  center(df);
}

void internal::Snap_equations::center(Points& df) const
{
  int components = 0;
  for (const int c : m_components) components = (std::max)(components, c + 1);
  Points sum = Points::Zero(3, components);
  Eigen::VectorXd count = Eigen::VectorXd::Zero(components);
  for (int v = 0; v < df.cols(); ++v) {
    sum.col(m_components[static_cast<std::size_t>(v)]) += df.col(v);
    ++count[m_components[static_cast<std::size_t>(v)]];
  }
  for (int v = 0; v < df.cols(); ++v) {
    const int component = m_components[static_cast<std::size_t>(v)];
    df.col(v) -= sum.col(component) / count[component];
  }
}

}  // namespace Conformal_geometry_processing
