// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/config.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief a triangle of a surface in the plane of a face of its mesh: the domain of integration of
/// every operator, see `ConformalSurface`.
///
/// Functions on the vertices are linear on the triangle; the tangent plane is that of the face. A
/// triangle that passes through several faces has one sheet in each, with the share of its area
/// that lies in the face.
struct Sheet {
  std::array<int, 3> corners;  ///< vertices, counter-clockwise; one may occur twice
  std::array<int, 3> edges;    ///< the edge opposite each corner, -1 if it has no number
  int triangle;                ///< of the surface; sheets are ordered by it
  int face;                    ///< of the mesh
  double area;                 ///< of the triangle
  double share;                ///< of the area that lies in the face; the shares of a triangle add
                               ///< up to 1
  Eigen::Matrix3d vectors;     ///< column c: from corner c + 1 to corner c + 2, in the face's plane
};

/// one point or vector of R^3 per column
using Points = Eigen::Matrix3Xd;

namespace internal {

/// \brief what the faces of a `Mesh_view` are without positions; its copies share it.
struct Mesh_connectivity {
  using Corners = std::vector<std::array<int, 3>>;

  Mesh_connectivity() = default;

  /// \throw Precondition_error, see `Mesh_view`
  Mesh_connectivity(Corners faces, int size_of_vertices);

  int from(int h) const { return corners[index(h / 3)][index((h + 1) % 3)]; }
  int to(int h) const { return corners[index(h / 3)][index((h + 2) % 3)]; }

  Corners corners;                       // |F|
  std::vector<int> halfedges;            // all of them, sorted by edge
  std::vector<int> first;                // |E| + 1: where an edge begins in halfedges
  std::vector<std::array<int, 2>> ends;  // |E|
  std::vector<int> edges, twins;         // 3 |F|

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int low(int h) const { return (std::min)(from(h), to(h)); }
  int high(int h) const { return (std::max)(from(h), to(h)); }

  void check_corners(int size_of_vertices) const;
  void sort_halfedges(int size_of_vertices);
  void number_edges();
  void pair_halfedges();
};

}  // namespace internal

/// \ingroup PkgMesh
/// \brief a triangle mesh as flat arrays: the input of all kernels of the library.
///
/// Vertices, edges and faces are numbered from 0 without gaps. Corner c of face f is the vertex
/// `corners(f)[c]`; the halfedge h = 3 f + c runs along the edge *opposite* that corner, from
/// corner c + 1 to corner c + 2, as the edges e_j of [CGP (5.1)] do. Faces are oriented counter-
/// clockwise seen from outside. Coordinates are `double` for every kernel of the mesh.
///
/// `Graph_view` makes it from any CGAL mesh; it can also be made from arrays. The constructor
/// checks no more than that every corner is a vertex; `mesh/requirements.h` does the rest, and
/// names the offending element. O(|V| + |F|). A model of `ConformalSurface`.
class Mesh_view {
 public:
  using Corners = internal::Mesh_connectivity::Corners;

  Mesh_view() = default;

  /// \param positions 3 x |V|
  /// \param corners the vertices of each face, counter-clockwise
  /// \throw Precondition_error if an index is not in [0, |V|), or there are more faces than
  /// halfedges can be counted with an `int`
  Mesh_view(Points positions, Corners corners);

  int size_of_vertices() const { return static_cast<int>(m_positions.cols()); }
  int size_of_faces() const { return static_cast<int>(corners().size()); }
  int size_of_edges() const { return static_cast<int>(ends().size()); }
  int size_of_halfedges() const { return 3 * size_of_faces(); }

  const Points& positions() const { return m_positions; }
  Eigen::Vector3d position(int v) const { return m_positions.col(v); }

  /// sets other positions, 3 x |V|, with the same connectivity
  /// \throw Precondition_error if there are not |V| of them
  void set_positions(Points positions);

  const Corners& corners() const { return m_connectivity->corners; }
  const std::array<int, 3>& corners(int f) const { return corners()[index(f)]; }

  /// the ends of halfedge h, from -> to
  int from(int h) const { return m_connectivity->from(h); }
  int to(int h) const { return m_connectivity->to(h); }
  static int face(int h) { return h / 3; }

  /// the next and the previous halfedge around the same face
  static int next_in_face(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous_in_face(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

  /// the vector along halfedge h
  Eigen::Vector3d vector(int h) const { return position(to(h)) - position(from(h)); }

  /// the opposite halfedge in the neighbouring face, -1 at the boundary
  int twin(int h) const { return m_connectivity->twins[index(h)]; }

  /// the number of the edge of halfedge h
  int edge(int h) const { return m_connectivity->edges[index(h)]; }

  /// the ends i < j of edge k, which is oriented i -> j; edges are sorted by (i, j)
  const std::array<int, 2>& ends(int k) const { return ends()[index(k)]; }

  /// the ends of all edges
  const std::vector<std::array<int, 2>>& ends() const { return m_connectivity->ends; }

  /// the halfedges along edge k: two opposite ones in the interior, one at the boundary, more where
  /// the mesh is not a manifold
  const int* halfedges_begin(int k) const
  {
    return m_connectivity->halfedges.data() + m_connectivity->first[index(k)];
  }
  const int* halfedges_end(int k) const
  {
    return m_connectivity->halfedges.data() + m_connectivity->first[index(k) + 1];
  }

  /// e_0 x e_1 of face f: the outward normal with twice the area as length
  Eigen::Vector3d double_area_vector(int f) const { return double_area_vector(f, m_positions); }

  /// e_0 x e_1 of face f for other positions of the vertices, 3 x |V|
  Eigen::Vector3d double_area_vector(int f, const Points& positions) const;

  /// for `ConformalSurface`: each face is a triangle with one sheet
  int size_of_sheets() const { return size_of_faces(); }
  Sheet sheet(int f) const;

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void measure_areas();

  Points m_positions;  // 3 x |V|
  std::shared_ptr<const internal::Mesh_connectivity> m_connectivity =
      std::make_shared<const internal::Mesh_connectivity>();
  std::vector<double> m_areas;  // |F|: sheets are read in every loop
};

/// \ingroup PkgMesh
/// Returns the length of a vector without overflow or underflow. (Eigen's `stableNorm()` is for
/// vectors of any size, and takes longer to compile than most callers of this function.)
double stable_norm(const Eigen::Vector3d& v);

/// \ingroup PkgMesh
/// Returns the unit vector in the direction of a vector of any length; zero for zero
Eigen::Vector3d stable_normalized(const Eigen::Vector3d& v);

}  // namespace Conformal_geometry_processing
