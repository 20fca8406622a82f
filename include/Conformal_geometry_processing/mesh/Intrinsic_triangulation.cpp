// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>

#include <Conformal_geometry_processing/mesh/requirements.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace Conformal_geometry_processing {

Eigen::VectorXd edge_lengths(const Mesh_view& mesh)
{
  Eigen::VectorXd lengths(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    lengths[k] = (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).stableNorm();
  return lengths;
}

internal::Mollified_lengths mollified_lengths(const Mesh_view& mesh, double share)
{
  internal::Mollified_lengths result;
  result.lengths = edge_lengths(mesh);
  const double slack = share * result.lengths.mean();
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::Vector3d l;
    for (int c = 0; c < 3; ++c) l[c] = result.lengths[mesh.edge(3 * f + c)];
    const double missing = slack + 2 * l.maxCoeff() - l.sum();
    result.thin_faces += missing > 0;
    result.added = (std::max)(result.added, missing);
  }
  result.lengths.array() += result.added;
  return result;
}

internal::Intrinsic_triangulation::Intrinsic_triangulation(const Mesh_view& mesh,
                                                           const Eigen::VectorXd& lengths)
    : m_corners(index(mesh.size_of_halfedges())),
      m_twins(index(mesh.size_of_halfedges())),
      m_lengths(index(mesh.size_of_halfedges()))
{
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    m_corners[index(h)] = mesh.corners(h / 3)[index(h % 3)];
    m_twins[index(h)] = mesh.twin(h);
    m_lengths[index(h)] = lengths[mesh.edge(h)];
  }
}

double internal::Intrinsic_triangulation::area(int f) const
{
  std::array<double, 3> l = {length(3 * f), length(3 * f + 1), length(3 * f + 2)};
  std::sort(l.begin(), l.end());
  const auto [c, b, a] = l;
  // Of two products, for one of four lengths would overflow or underflow.
  return std::sqrt((a + (b + c)) * (a + (b - c))) *
         std::sqrt((std::max)((c - (a - b)) * (c + (a - b)), 0.)) / 4;
}

Eigen::Vector2d internal::Intrinsic_triangulation::apex_in_plane(int h) const
{
  const double l = length(h), a = length(Mesh_view::next_in_face(h)),
               b = length(Mesh_view::previous_in_face(h));
  return {(l + (b - a) * (b + a) / l) / 2, 2 * area(h / 3) / l};
}

double internal::Intrinsic_triangulation::angle(int h) const
{
  const double l = length(h), a = length(Mesh_view::next_in_face(h)),
               b = length(Mesh_view::previous_in_face(h));
  return std::atan2(4 * area(h / 3), a * a + (b - l) * (b + l));
}

double internal::Intrinsic_triangulation::cotangent(int h) const
{
  const double l = length(h), a = length(Mesh_view::next_in_face(h)),
               b = length(Mesh_view::previous_in_face(h));
  return (a * a + (b - l) * (b + l)) / (4 * area(h / 3));
}

double internal::Intrinsic_triangulation::length_of_flipped(int h) const
{
  const Eigen::Vector2d k = apex_in_plane(h), l = apex_in_plane(twin(h));
  return std::hypot(k.x() - (length(h) - l.x()), k.y() + l.y());
}

void internal::Intrinsic_triangulation::flip(int h)
{
  const int t = twin(h), a = h / 3, b = t / 3;
  const double diagonal = length_of_flipped(h);
  const int i = from(h), j = to(h), k = apex(h), l = apex(t);
  // the four sides: i l, k i of the new face a, and j k, l j of the new face b
  const std::array<int, 4> before = {Mesh_view::next_in_face(t), Mesh_view::previous_in_face(h),
                                     Mesh_view::next_in_face(h), Mesh_view::previous_in_face(t)};
  const std::array<int, 4> after = {3 * a, 3 * a + 2, 3 * b, 3 * b + 2};
  std::array<int, 4> twins;
  std::array<double, 4> lengths;
  for (std::size_t s = 0; s < 4; ++s) {
    const auto side = std::find(before.begin(), before.end(), twin(before[s]));  // glued together
    twins[s] = side == before.end() ? twin(before[s])
                                    : after[static_cast<std::size_t>(side - before.begin())];
    lengths[s] = length(before[s]);
  }
  for (std::size_t s = 0; s < 4; ++s) glue(after[s], twins[s], lengths[s]);
  glue(3 * a + 1, 3 * b + 1, diagonal);
  m_lengths[index(3 * b + 1)] = diagonal;
  const std::array<int, 3> at_a = {k, i, l}, at_b = {l, j, k};
  std::copy(at_a.begin(), at_a.end(), m_corners.begin() + 3 * a);
  std::copy(at_b.begin(), at_b.end(), m_corners.begin() + 3 * b);
}

void internal::Intrinsic_triangulation::glue(int h, int twin, double length)
{
  m_lengths[index(h)] = length;
  m_twins[index(h)] = twin;
  if (twin >= 0) m_twins[index(twin)] = h;
}

bool is_delaunay(const internal::Intrinsic_triangulation& triangles, int h)
{
  const double pi = std::acos(-1.), tolerance = 1e-10;
  const int t = triangles.twin(h);
  // Written so that what is not a number is never flipped.
  return t < 0 || !(triangles.angle(h) + triangles.angle(t) > pi + tolerance);
}

int flip_to_delaunay(internal::Intrinsic_triangulation& triangles)
{
  return flip_to_delaunay(triangles, [](int) {});
}

namespace internal {

/// \ingroup PkgMesh
/// The pairs of vertices that the edges of a triangulation join
class Joined_vertices {
 public:
  explicit Joined_vertices(const Mesh_view& mesh) : m_pairs(mesh.ends().begin(), mesh.ends().end())
  {}

  bool contain(int a, int b) const { return m_pairs.count({(std::min)(a, b), (std::max)(a, b)}); }

  void flip(const Intrinsic_triangulation& triangles, int h)
  {
    const auto pair = [](int a, int b) {
      return std::array<int, 2>{(std::min)(a, b), (std::max)(a, b)};
    };
    m_pairs.erase(pair(triangles.from(h), triangles.to(h)));
    m_pairs.insert(pair(triangles.apex(h), triangles.apex(triangles.twin(h))));
  }

 private:
  std::set<std::array<int, 2>> m_pairs;
};

// Whether the chords of the two faces after a flip enclose an area.
inline bool has_area_when_flipped(const Mesh_view& mesh, const Intrinsic_triangulation& triangles,
                                  int h)
{
  const int k = triangles.apex(h), l = triangles.apex(triangles.twin(h));
  for (const int v : {triangles.from(h), triangles.to(h)}) {
    Eigen::Matrix3d edges;
    edges << mesh.position(v) - mesh.position(l), mesh.position(k) - mesh.position(v),
        mesh.position(l) - mesh.position(k);
    if (has_area_zero(edges)) return false;
  }
  return true;
}

/// the vertices opposite to long edges of thin faces: the tip of a cap, both ends of a needle
inline std::set<int> tips_of_thin_faces(const Mesh_view& mesh, double share)
{
  const double is_long = .75;  // by the longest
  std::set<int> tips;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::Vector3d l;
    for (int c = 0; c < 3; ++c) l[c] = mesh.vector(3 * f + c).stableNorm();
    const double longest = l.maxCoeff();
    if (l.sum() - 2 * longest >= share * longest && longest > 0) continue;
    for (int c = 0; c < 3; ++c)
      if (l[c] >= is_long * longest) tips.insert(mesh.corners(f)[static_cast<std::size_t>(c)]);
  }
  return tips;
}

/// the sums of the vectors from the vertices to their neighbours, over all faces, and of the
/// normals
struct Vertex_surroundings {
  explicit Vertex_surroundings(const Mesh_view& mesh)
      : to_neighbours(Points::Zero(3, mesh.size_of_vertices())),
        normals(to_neighbours),
        counts(Eigen::VectorXd::Zero(mesh.size_of_vertices()))
  {
    for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
      const int from = mesh.from(h), to = mesh.to(h);
      to_neighbours.col(from) += mesh.vector(h);
      to_neighbours.col(to) -= mesh.vector(h);
      counts[from] += 1, counts[to] += 1;
      normals.col(from) += mesh.double_area_vector(Mesh_view::face(h));
    }
  }

  /// to the mean of the neighbours, along the surface
  Eigen::Vector3d way_in(int v) const
  {
    const Eigen::Vector3d way = to_neighbours.col(v) / counts[v],
                          normal = normals.col(v).stableNormalized();
    return way - way.dot(normal) * normal;
  }

  Points to_neighbours, normals;
  Eigen::VectorXd counts;
};

}  // namespace internal

Mesh_view internal::simple_delaunay(const Mesh_view& mesh, double mollification,
                                    std::vector<std::array<int, 2>>* flips)
{
  Intrinsic_triangulation triangles(mesh, mollification > 0
                                              ? mollified_lengths(mesh, mollification).lengths
                                              : edge_lengths(mesh));
  Joined_vertices joined(mesh);
  const auto may_flip = [&](int h) {
    const int k = triangles.apex(h), l = triangles.apex(triangles.twin(h));
    return k != l && !joined.contain(k, l) && has_area_when_flipped(mesh, triangles, h);
  };
  const auto flipped = [&](int h) {
    if (flips) flips->push_back({triangles.from(h), triangles.to(h)});
    joined.flip(triangles, h);
  };
  if (flip_to_delaunay(triangles, may_flip, flipped) == 0) return mesh;
  Mesh_view::Corners corners(static_cast<std::size_t>(mesh.size_of_faces()));
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    corners[static_cast<std::size_t>(f)] = {triangles.apex(3 * f), triangles.apex(3 * f + 1),
                                            triangles.apex(3 * f + 2)};
  return {mesh.positions(), std::move(corners)};
}

Mesh_view internal::delaunay_by_chords(Mesh_view mesh, double mollification,
                                       std::vector<std::array<int, 2>>& flips)
{
  const int most_rounds = 20;
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t before = flips.size();
    mesh = simple_delaunay(mesh, mollification, &flips);
    if (flips.size() == before) break;
  }
  return mesh;
}

Mesh_view internal::with_opened_faces(const Mesh_view& mesh, double share)
{
  const int passes = 20;  // a few are enough where one vertex can be moved out of the way
  Mesh_view opened = mesh;
  for (int pass = 0; pass < passes; ++pass) {
    const std::set<int> tips = tips_of_thin_faces(opened, share);
    if (tips.empty()) break;
    const Vertex_surroundings surroundings(opened);
    Points moved = opened.positions();
    for (const int v : tips) moved.col(v) += std::sqrt(share) * surroundings.way_in(v);
    opened.set_positions(moved);
  }
  return opened;
}

}  // namespace Conformal_geometry_processing
