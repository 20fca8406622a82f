// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
/// \brief A triangulation given by edge lengths only, with intrinsic edge flips [Fisher et al.
/// 2007; Bobenko and Springborn 2007].
///
/// Indices as in `Mesh_view`: halfedge h = 3 f + c is opposite corner c of face f. Flips preserve
/// the number of vertices and faces, but not the meaning of face and halfedge indices. After flips
/// the two ends of an edge may coincide, two edges may have the same ends, and a face may have the
/// same vertex at two corners: this is still a triangulation of the surface.
class Intrinsic_triangulation {
 public:
  /// \param mesh an oriented manifold, with or without boundary
  /// \param lengths |E|, the edge lengths of the mesh, which satisfy the triangle inequality
  Intrinsic_triangulation(const Mesh_view& mesh, const Eigen::VectorXd& lengths);

  int size_of_faces() const { return size_of_halfedges() / 3; }
  int size_of_halfedges() const { return static_cast<int>(m_corners.size()); }

  /// The vertex opposite halfedge h
  int apex(int h) const { return m_corners[index(h)]; }
  int from(int h) const { return apex(Mesh_view::next_in_face(h)); }
  int to(int h) const { return apex(Mesh_view::previous_in_face(h)); }

  /// The opposite halfedge in the neighbouring face, -1 at the boundary
  int twin(int h) const { return m_twins[index(h)]; }
  double length(int h) const { return m_lengths[index(h)]; }

  /// Area by Kahan's formula, which is numerically stable for slivers
  double area(int f) const;

  /// Position of the apex of h if h starts at (0, 0) along the x-axis and its face is above
  Eigen::Vector2d apex_in_plane(int h) const;

  /// The angle opposite h, in [0, pi]
  double angle(int h) const;

  /// The cotangent of the angle opposite h
  double cotangent(int h) const;

  /// Length of the other diagonal of the two triangles at h, laid out in the plane
  /// \pre h has a twin
  double length_of_flipped(int h) const;

  /// \brief Replaces the diagonal i -> j of the two triangles at h by the other one.
  ///
  /// With k the apex of h and l that of its twin, the face of h becomes (k, i, l) and the face of
  /// the twin (l, j, k), corners 0, 1, 2 in this order.
  /// \pre h has a twin in a different face, and the two triangles form a convex quadrilateral
  void flip(int h);

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void glue(int h, int twin, double length);

  std::vector<int> m_corners, m_twins;  // 3 |F|
  std::vector<double> m_lengths;        // 3 |F|, the same for both halfedges of an edge
};

}  // namespace Conformal_geometry_processing::internal
