// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_INTRINSIC_TRIANGULATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_INTRINSIC_TRIANGULATION_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief triangles known by the lengths of their edges alone, whose edges can be flipped inside
/// the surface [Fisher et al. 2007; Bobenko and Springborn 2007].
///
/// Numbers are those of `Mesh_view`: halfedge h = 3 f + c is opposite corner c of face f. Flips
/// keep the numbers of vertices and faces, not what they mean. After flips an edge may have twice
/// the same end, two edges the same ends, and a face twice the same corner: a triangulation of
/// the surface all the same.
class Intrinsic_triangulation {
 public:
  /// \param mesh an oriented manifold, with or without boundary
  /// \param lengths |E|, of the edges of the mesh, so that the triangle inequality holds
  Intrinsic_triangulation(const Mesh_view& mesh, const Eigen::VectorXd& lengths)
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

  int size_of_faces() const { return size_of_halfedges() / 3; }
  int size_of_halfedges() const { return static_cast<int>(m_corners.size()); }

  /// the vertex opposite halfedge h
  int apex(int h) const { return m_corners[index(h)]; }
  int from(int h) const { return apex(Mesh_view::next_in_face(h)); }
  int to(int h) const { return apex(Mesh_view::previous_in_face(h)); }

  /// the halfedge of the neighbouring face, -1 at the boundary
  int twin(int h) const { return m_twins[index(h)]; }
  double length(int h) const { return m_lengths[index(h)]; }

  /// by Kahan's formula, which loses no digits on slivers but those that the lengths have lost
  double area(int f) const
  {
    std::array<double, 3> l = {length(3 * f), length(3 * f + 1), length(3 * f + 2)};
    std::sort(l.begin(), l.end());
    const auto [c, b, a] = l;
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return std::sqrt((std::max)(product, 0.)) / 4;
  }

  /// where the apex of h is if h runs from (0, 0) along the x-axis and its face is above
  Eigen::Vector2d apex_in_plane(int h) const
  {
    const double l = length(h), a = length(Mesh_view::next_in_face(h)),
                 b = length(Mesh_view::previous_in_face(h));
    return {(l + (b - a) * (b + a) / l) / 2, 2 * area(h / 3) / l};
  }

  /// the angle opposite h, in [0, pi]
  double angle(int h) const
  {
    const double l = length(h), a = length(Mesh_view::next_in_face(h)),
                 b = length(Mesh_view::previous_in_face(h));
    return std::atan2(4 * area(h / 3), a * a + (b - l) * (b + l));
  }

  /// the cotangent of that angle
  double cotangent(int h) const
  {
    const double l = length(h), a = length(Mesh_view::next_in_face(h)),
                 b = length(Mesh_view::previous_in_face(h));
    return (a * a + (b - l) * (b + l)) / (4 * area(h / 3));
  }

  /// the length of the other diagonal of the two triangles at h, laid out in the plane
  /// \pre h has a twin
  double length_of_flipped(int h) const
  {
    const Eigen::Vector2d k = apex_in_plane(h), l = apex_in_plane(twin(h));
    return std::hypot(k.x() - (length(h) - l.x()), k.y() + l.y());
  }

  /// \brief replaces the diagonal i -> j of the two triangles at h by the other one.
  ///
  /// With k the apex of h and l that of its twin, the face of h becomes (k, i, l) and the face of
  /// the twin (l, j, k), corners 0, 1, 2 in this order.
  /// \pre h has a twin, of another face, and their triangles form a convex quadrangle
  void flip(int h)
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

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void glue(int h, int twin, double length)
  {
    m_lengths[index(h)] = length;
    m_twins[index(h)] = twin;
    if (twin >= 0) m_twins[index(twin)] = h;
  }

  std::vector<int> m_corners, m_twins;  // 3 |F|
  std::vector<double> m_lengths;        // 3 |F|, the same for both halfedges of an edge
};

}  // namespace Conformal_geometry_processing

#endif
