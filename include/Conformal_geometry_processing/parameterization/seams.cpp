// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/seams.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <cmath>
#include <cstddef>
#include <deque>
#include <map>

namespace Conformal_geometry_processing::internal {
namespace {

const double half_turn = std::acos(-1.);

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
        direction += half_turn - angle_at_end(h);
        waiting.push_back(h);
      }
    };
    for (place(0, 0); !waiting.empty(); waiting.pop_front()) {
      const int h = waiting.front(), t = mesh.twin(h);
      if (t >= 0) place(t, m_directions[h] + half_turn + turn(h, t));
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
        unfolding.direction(t) - unfolding.direction(h) - half_turn - unfolding.turn(h, t);
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
