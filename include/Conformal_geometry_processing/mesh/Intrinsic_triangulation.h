// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_INTRINSIC_TRIANGULATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_INTRINSIC_TRIANGULATION_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

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
  Intrinsic_triangulation(const Mesh_view& mesh, const Eigen::VectorXd& lengths);

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
  double area(int f) const;

  /// where the apex of h is if h runs from (0, 0) along the x-axis and its face is above
  Eigen::Vector2d apex_in_plane(int h) const;

  /// the angle opposite h, in [0, pi]
  double angle(int h) const;

  /// the cotangent of that angle
  double cotangent(int h) const;

  /// the length of the other diagonal of the two triangles at h, laid out in the plane
  /// \pre h has a twin
  double length_of_flipped(int h) const;

  /// \brief replaces the diagonal i -> j of the two triangles at h by the other one.
  ///
  /// With k the apex of h and l that of its twin, the face of h becomes (k, i, l) and the face of
  /// the twin (l, j, k), corners 0, 1, 2 in this order.
  /// \pre h has a twin, of another face, and their triangles form a convex quadrangle
  void flip(int h);

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void glue(int h, int twin, double length);

  std::vector<int> m_corners, m_twins;  // 3 |F|
  std::vector<double> m_lengths;        // 3 |F|, the same for both halfedges of an edge
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation_impl.h>
#endif

#endif
