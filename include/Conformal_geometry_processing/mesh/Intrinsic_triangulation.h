// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// Returns the lengths of the edges, |E|
Eigen::VectorXd edge_lengths(const Mesh_view& mesh);

namespace internal {

/// Edge lengths without degenerate triangles
struct Mollified_lengths {
  Eigen::VectorXd lengths;  ///< |E|
  double added = 0;         ///< length added to each edge
  int thin_faces = 0;       ///< number of faces that violated the triangle inequality
};

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

/// \brief The mesh with the connectivity of its intrinsic Delaunay triangulation, as a mesh whose
/// edges are chords: its faces are well shaped where those of the input are slivers.
///
/// Flips that would join two vertices twice are left out, so every edge is determined by its ends,
/// and so are those that would give a face without area. The vertices, their numbers and the
/// boundary stay. A mesh that is Delaunay already is returned unchanged.
/// \param mesh an oriented manifold with or without boundary
/// \param mollification of the lengths by which edges are flipped, see `mollified_lengths()`; zero:
/// none, and no edge has length zero
/// \param flips receives the ends that each flipped edge had, in their order
Mesh_view simple_delaunay(const Mesh_view& mesh, double mollification = 0,
                          std::vector<std::array<int, 2>>* flips = nullptr);

/// \brief Likewise, Delaunay by its own edges: chords are shorter than what they stand for in the
/// intrinsic triangulation, so it is flipped again until nothing changes (mostly two or three
/// times).
Mesh_view delaunay_by_chords(Mesh_view mesh, double mollification,
                             std::vector<std::array<int, 2>>& flips);

/// \brief The mesh with vertices moved until all faces have an area, for algorithms on chords.
///
/// A face is thin if its longest edge is not shorter than the sum of the two others by at least
/// `share` of it. Its tips, those opposite to long edges, move along the surface, towards the mean
/// of their neighbours, by the root of `share` of the way: `mollified_lengths()` gives triangles of
/// three collinear points such a height. All other vertices stay to the bit.
///
/// Faces remain thin where whole neighbourhoods lie on a line or in a point.
/// \param share positive
Mesh_view with_opened_faces(const Mesh_view& mesh, double share);

}  // namespace internal

/// \ingroup PkgMesh
/// \brief Mollifies the edge lengths: adds the smallest constant to all of them such that in every
/// triangle the longest edge is shorter than the sum of the two others by at least `share` times
/// the mean length [Sharp and Crane 2020, 4.5].
///
/// Then no triangle is degenerate, even if points are collinear or coincide. The lengths of a mesh
/// without degenerate triangles are unchanged to the bit. A triangle of three collinear points gets
/// a height of about the square root of `share` times its length, two coinciding points a distance
/// of `share`.
/// \param share positive; below about 1e-12, rounding determines the shape of triangles
internal::Mollified_lengths mollified_lengths(const Mesh_view& mesh, double share);

/// \ingroup PkgMesh
/// \brief Returns whether the sum of the angles opposite the edge of h is at most pi, so that its
/// cotan weight is not negative; true for boundary edges.
///
/// Tolerates an excess of 1e-10, to avoid infinite flipping due to rounding.
bool is_delaunay(const internal::Intrinsic_triangulation& triangles, int h);

/// \ingroup PkgMesh
/// \brief Flips edges until all are Delaunay [Bobenko and Springborn 2007]. Every flip reduces the
/// Dirichlet energy of piecewise linear functions, down to the minimum over all triangulations.
///
/// \param may_flip called with a halfedge of each edge that is not Delaunay; left as it is if false
/// \param before_flip called with a halfedge of each edge before it is flipped
/// \returns the number of flips; usually a few per badly shaped triangle
template <class MayFlip, class BeforeFlip>
int flip_to_delaunay(internal::Intrinsic_triangulation& triangles, MayFlip may_flip,
                     BeforeFlip before_flip)
{
  std::deque<int> waiting;
  for (int h = 0; h < triangles.size_of_halfedges(); ++h)
    if (h < triangles.twin(h)) waiting.push_back(h);
  int flips = 0;
  while (!waiting.empty()) {
    const int h = waiting.front(), t = triangles.twin(h);
    waiting.pop_front();
    // If both sides of an edge are the same face, the sum of the two angles is less than pi.
    if (t < 0 || h / 3 == t / 3 || is_delaunay(triangles, h) || !may_flip(h)) continue;
    before_flip(h);
    triangles.flip(h);
    ++flips;
    for (const int face : {h / 3, t / 3})
      for (const int side : {0, 2}) waiting.push_back(3 * face + side);  // 1 is the new edge
  }
  return flips;
}

/// \ingroup PkgMesh
/// Flips all edges that are not Delaunay
template <class BeforeFlip>
int flip_to_delaunay(internal::Intrinsic_triangulation& triangles, BeforeFlip before_flip)
{
  return flip_to_delaunay(
      triangles, [](int) { return true; }, before_flip);
}

/// \ingroup PkgMesh
/// Flips edges likewise, without a callback
int flip_to_delaunay(internal::Intrinsic_triangulation& triangles);

}  // namespace Conformal_geometry_processing
