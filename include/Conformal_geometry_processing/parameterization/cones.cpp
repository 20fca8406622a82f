// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/cones.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>

namespace Conformal_geometry_processing::internal {

namespace {

const double pi = std::acos(-1.);

/// where u is given: at the boundary, or at one vertex of a closed surface, as u is known up to a
/// constant
std::vector<int> grounded_vertices(const Mesh_view& mesh)
{
  const std::vector<char> is_there = boundary_vertices(mesh);
  std::vector<int> found;
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (is_there[static_cast<std::size_t>(v)]) found.push_back(v);
  return found.empty() ? std::vector<int>{0} : found;
}

/// The variance of u = u_0 + sum of defect_c g_c over the area, where L g_c is the Dirac measure of
/// cone c, less that of the area where the surface is closed
class Scale_variance {
 public:
  /// \param count of cones that are to come
  Scale_variance(const Mesh_view& mesh, int count)
      : m_is_closed(is_closed(mesh)),
        m_laplacian(cotan_laplacian(mesh)),
        m_solver(vertex_graph(mesh), grounded_vertices(mesh)),
        m_areas(vertex_areas(mesh) / vertex_areas(mesh).sum()),
        m_curvature(angle_defects(mesh))
  {
    m_solver.factorize(m_laplacian);
    m_u = centred(solve(spread(m_curvature.sum()) - m_curvature));
    m_responses.resize(m_areas.size(), 0);
    const double share = m_is_closed ? m_curvature.sum() / count : 0;
    m_largest = (std::max)(pi, share);
    m_least = (std::min)(-pi, share);
  }

  int size_of_cones() const { return static_cast<int>(m_cones.size()); }

  Cone_metric metric() const
  {
    Cone_metric metric{m_cones, scale()};
    for (std::size_t c = 0; c < m_cones.size(); ++c)
      metric.cones[c].defect = m_defects[static_cast<Eigen::Index>(c)];
    return metric;
  }

  void add(const Cone& cone)
  {
    m_cones.push_back(cone);
    Eigen::VectorXd source = -spread(1);
    source[cone.vertex] += 1;
    m_responses.conservativeResize(Eigen::NoChange, m_responses.cols() + 1);
    m_responses.rightCols<1>() = centred(solve(source));
    minimize();
  }

  /// The vertex where a cone changes the variance most, for a small defect that the others of a
  /// closed surface lose
  int best_vertex() const
  {
    const Eigen::VectorXd slope = solve(m_areas.cwiseProduct(scale()));
    const std::vector<Eigen::Index> free = free_cones();
    Eigen::VectorXd gain = slope.cwiseAbs();
    if (m_is_closed && free.empty()) gain = -slope;  // of a first positive defect
    if (m_is_closed && !free.empty()) {
      double level = 0;
      for (const Eigen::Index c : free) level += slope[m_cones[static_cast<std::size_t>(c)].vertex];
      gain = (slope.array() - level / static_cast<double>(free.size())).abs();
    }
    for (const Cone& cone : m_cones) gain[cone.vertex] = -HUGE_VAL;
    Eigen::Index best = 0;
    gain.maxCoeff(&best);
    return static_cast<int>(best);
  }

 private:
  static bool is_closed(const Mesh_view& mesh) { return topology(mesh).is_closed(); }

  /// A curvature on the whole of a closed surface, which has no place elsewhere
  Eigen::VectorXd spread(double curvature) const { return (m_is_closed ? curvature : 0) * m_areas; }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const
  {
    return m_solver.solve(m_laplacian, b, Eigen::VectorXd::Zero(b.size()));
  }

  Eigen::VectorXd centred(Eigen::VectorXd u) const
  {
    u.array() -= m_areas.dot(u);
    return u;
  }

  Eigen::VectorXd scale() const { return m_u + m_responses * m_defects; }

  /// those whose defects are not given, and have not reached a bound
  std::vector<Eigen::Index> free_cones() const
  {
    std::vector<Eigen::Index> free;
    for (std::size_t c = 0; c < m_cones.size(); ++c) {
      const double defect = m_defects[static_cast<Eigen::Index>(c)];
      const bool is_inside = m_least < defect && defect < m_largest;
      if (!m_cones[c].defect && is_inside) free.push_back(static_cast<Eigen::Index>(c));
    }
    return free;
  }

  /// Finds the defects; those beyond a bound are set to it, one after the other.
  void minimize()
  {
    m_defects.resize(size_of_cones());
    for (int c = 0; c < size_of_cones(); ++c)
      m_defects[c] = m_cones[static_cast<std::size_t>(c)].defect.value_or(0);
    for (auto free = free_cones(); !free.empty(); free = free_cones()) {
      const Eigen::VectorXd defects = least_variance(free);
      const Eigen::VectorXd within = defects.cwiseMin(m_largest).cwiseMax(m_least);
      Eigen::Index worst = 0;
      if ((defects - within).cwiseAbs().maxCoeff(&worst) == 0 ||
          (m_is_closed && free.size() == 1)) {
        m_defects(free) = defects;
        return;
      }
      m_defects(free).setZero();
      m_defects[free[static_cast<std::size_t>(worst)]] = within[worst];
    }
  }

  /// The defects of the free cones, the others given: a quadratic problem, with one constraint if
  /// the surface is closed
  Eigen::VectorXd least_variance(const std::vector<Eigen::Index>& free) const
  {
    const auto n = static_cast<Eigen::Index>(free.size());
    const Eigen::MatrixXd g = m_responses(Eigen::indexing::all, free);
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n + 1, n + 1);
    A.topLeftCorner(n, n) = g.transpose() * m_areas.asDiagonal() * g;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
    b.head(n) = -g.transpose() * m_areas.cwiseProduct(scale());  // in which theirs are zero
    if (m_is_closed) {
      A.row(n) << Eigen::RowVectorXd::Ones(n), 0;
      A.col(n) = A.row(n).transpose();
      b[n] = m_curvature.sum() - m_defects.sum();
    }
    return A.fullPivLu().solve(b).head(n);
  }

  bool m_is_closed;
  Hermitian_sparse_matrix<double> m_laplacian;
  Dirichlet_solver<double> m_solver;
  Eigen::VectorXd m_areas, m_curvature, m_u;
  Eigen::MatrixXd m_responses;  // |V| x cones
  std::vector<Cone> m_cones;    // as they are wanted
  Eigen::VectorXd m_defects;
  double m_least = 0, m_largest = 0;  // of them
};

}  // namespace

Cone_metric place_cones(const Mesh_view& mesh, int count, const std::vector<Cone>& first)
{
  Scale_variance variance(mesh, count);
  for (const Cone& cone : first) variance.add(cone);
  while (variance.size_of_cones() < count) variance.add({variance.best_vertex()});
  return variance.metric();
}

namespace {

/// Halfedges along seams, by the origins of their ends
using Sides = std::map<std::array<int, 2>, int>;

/// The directions of the halfedges of each face, in the plane into which a disk is unfolded
class Unfolding {
 public:
  Unfolding(const Mesh_view& mesh, const Eigen::VectorXd& log_scale)
      : m_mesh(mesh), m_u(log_scale), m_directions(mesh.size_of_halfedges())
  {
    std::vector<char> is_placed(static_cast<std::size_t>(mesh.size_of_faces()), 0);
    std::deque<int> waiting;
    const auto place = [&](int h, double direction) {
      if (is_placed[static_cast<std::size_t>(h / 3)]++) return;
      for (int i = 0; i < 3; ++i, h = Mesh_view::next_in_face(h)) {
        m_directions[h] = direction;
        direction += pi - angle_at_end(h);
        waiting.push_back(h);
      }
    };
    for (place(0, 0); !waiting.empty(); waiting.pop_front()) {
      const int h = waiting.front(), t = mesh.twin(h);
      if (t >= 0) place(t, m_directions[h] + pi + turn(h, t));
    }
  }

  double direction(int h) const { return m_directions[h]; }

  /// by which the frame is turned that crosses h, whose other side is t
  double turn(int h, int t) const
  {
    const double weight = (cotangent(m_mesh, h) + cotangent(m_mesh, t)) / 2;
    return weight * (m_u[m_mesh.from(h)] - m_u[m_mesh.to(h)]);
  }

 private:
  double angle_at_end(int h) const { return corner_angle(m_mesh.sheet(h / 3), (h + 2) % 3); }

  const Mesh_view& m_mesh;
  const Eigen::VectorXd& m_u;
  Eigen::VectorXd m_directions;
};

/// a mesh with more pairs of neighbours, as the graph of its vertices sees it
struct Joined_mesh : Mesh_view {
  explicit Joined_mesh(const Mesh_view& mesh) : Mesh_view(mesh), pairs(mesh.ends()) {}

  const std::vector<std::array<int, 2>>& ends() const { return pairs; }

  std::vector<std::array<int, 2>> pairs;
};

/// by vertex, of what a seam misses
using Spring = std::map<int, std::complex<double>>;

Spring spring_of(const Seam& seam)
{
  Spring c;
  c[seam.right[1]] += 1;
  c[seam.right[0]] -= 1;
  c[seam.left[1]] -= seam.ratio;
  c[seam.left[0]] += seam.ratio;
  return c;
}

/// The halfedges at cuts and at the boundary
Sides sides_of(const Mesh_view& mesh, const std::vector<int>& origin)
{
  Sides sides;
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0)
      sides[{origin[static_cast<std::size_t>(mesh.from(h))],
             origin[static_cast<std::size_t>(mesh.to(h))]}] = h;
  return sides;
}

/// Joins each edge of the boundary before cuts to the next one, also where a cut ends between them.
void add_boundary(const Mesh_view& mesh, const Sides& sides, const Unfolding& unfolding,
                  std::vector<Seam>& seams)
{
  std::map<int, std::array<int, 2>> boundary;  // by the origin where it begins: where it ends, h
  for (const auto& [ends, h] : sides)
    if (sides.count({ends[1], ends[0]}) == 0) boundary[ends[0]] = {ends[1], h};
  for (const auto& [from, edge] : boundary) {
    const auto [to, h] = edge;
    const int t = boundary.at(to)[1];
    const double ratio = mesh.vector(t).norm() / mesh.vector(h).norm();
    seams.push_back({{mesh.from(h), mesh.to(h)},
                     {mesh.from(t), mesh.to(t)},
                     std::polar(ratio, unfolding.direction(t) - unfolding.direction(h))});
  }
}

}  // namespace

std::vector<Seam> seams_of(const Mesh_view& mesh, const std::vector<int>& origin,
                           const Eigen::VectorXd& log_scale)
{
  const Unfolding unfolding(mesh, log_scale);
  const Sides sides = sides_of(mesh, origin);
  std::vector<Seam> seams;
  for (const auto& [ends, h] : sides) {
    const auto other = sides.find({ends[1], ends[0]});
    if (other == sides.end() || ends[0] > ends[1]) continue;
    const int t = other->second;
    const double angle =
        unfolding.direction(t) - unfolding.direction(h) - pi - unfolding.turn(h, t);
    seams.push_back(
        {{mesh.from(h), mesh.to(h)}, {mesh.to(t), mesh.from(t)}, std::polar(1., angle)});
  }
  add_boundary(mesh, sides, unfolding, seams);
  return seams;
}

std::shared_ptr<const Sparse_pattern> graph_with_seams(const Mesh_view& mesh,
                                                       const std::vector<Seam>& seams)
{
  if (seams.empty()) return vertex_graph(mesh);
  Joined_mesh joined(mesh);
  for (const Seam& seam : seams)
    for (const auto& [v, a] : spring_of(seam))
      for (const auto& [w, b] : spring_of(seam))
        if (v < w) joined.pairs.push_back({v, w});
  return vertex_graph(joined);
}

void add_seams(const std::vector<Seam>& seams, double stiffness,
               Hermitian_sparse_matrix<std::complex<double>>& energy)
{
  for (const Seam& seam : seams) {
    const Spring c = spring_of(seam);
    for (const auto& [row, a] : c)
      for (const auto& [column, b] : c)
        if (row >= column)
          energy.value(energy.pattern().find(row, column)) += stiffness * std::conj(a) * b;
  }
}

}  // namespace Conformal_geometry_processing::internal
