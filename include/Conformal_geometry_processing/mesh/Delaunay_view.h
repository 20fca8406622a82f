// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief Finds the cap triangles at the boundary, whose angle opposite a boundary edge exceeds 150
/// degrees, and those that become caps after removal of other ones.
///
/// Flips cannot remove them, and the gradient of a linear function on a cap is the difference
/// between its corner and the middle of the boundary edge, divided by the small height of the cap.
/// `Delaunay_view` therefore uses functions that are constant along that height, with a kink at its
/// foot.
/// \returns for each triangle the halfedge opposite that angle, or -1
std::vector<int> boundary_caps(const internal::Intrinsic_triangulation& triangles);

namespace internal {

/// \brief Closed 1-forms on an intrinsic triangulation, updated by its flips: integrals along paths
/// do not change, because the sum around every triangle is zero.
///
/// Takes 2 k |E| numbers, and O(k) for every flip; nothing if there are no forms.
class Transported_forms {
 public:
  /// \param forms |E| x k, along each edge i -> j of the mesh, i < j; closed; may be empty
  Transported_forms(const Mesh_view& mesh, const Eigen::MatrixXd& forms);

  /// Values along halfedge h, from its first vertex to its second; k numbers
  auto along(int h) const { return m_values.row(h); }

  Eigen::Index size() const { return m_values.cols(); }

  /// \pre the edge of h is about to be flipped
  void before_flip(const Intrinsic_triangulation& triangles, int h);

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Rows m_values;  // one for each halfedge
  Rows m_sides;   // of the two triangles that a flip changes
};

/// A convex polygon in the plane, counter-clockwise
using Plane_polygon = std::vector<Eigen::Vector2d>;

/// its area, at least zero
double area_of(const Plane_polygon& polygon);

/// the part of a polygon on the left of the line from p to q
Plane_polygon clipped(const Plane_polygon& polygon, const Eigen::Vector2d& p,
                      const Eigen::Vector2d& q);

/// \brief Partition of the faces of a mesh by its intrinsic triangulation, and the embedding of the
/// pieces in space.
///
/// Follows the flips: the pieces of two triangles, laid out in the plane, are cut along the new
/// diagonal. Rounding shifts the cuts slightly, but each intrinsic face always has pieces with
/// positive weights.
class Common_subdivision {
 public:
  /// A convex part of a face, in the plane of the intrinsic face that contains it, where halfedge 3
  /// g starts at (0, 0) along the x-axis
  struct Piece {
    Plane_polygon polygon;
    double weight;                         ///< its area in the mesh
    int face;                              ///< of the mesh
    Eigen::Matrix<double, 3, 2> to_space;  ///< isometry from that plane to the plane of the face
  };

  /// \param mesh the mesh whose faces are the triangles, before any flip
  Common_subdivision(const Mesh_view& mesh, const Intrinsic_triangulation& triangles);
  const std::vector<Piece>& pieces(int face) const;

  /// pieces of all faces
  std::size_t size() const { return m_size; }

  /// There are no more pieces than so many times the faces.
  static constexpr std::size_t most_pieces_per_face = 100;

  /// \pre the edge of h is about to be flipped
  /// \throw Precondition_error if there would be more pieces than `most_pieces_per_face` each: thin
  /// faces that wind about each other have a number of pieces that is quadratic in that of the
  /// faces
  void before_flip(const Intrinsic_triangulation& triangles, int h);

 private:
  /// A point and a unit vector
  struct Frame {
    Eigen::Vector2d origin, direction;

    Eigen::Matrix2d rotation() const;
  };

  [[noreturn]] void refuse(const Intrinsic_triangulation& triangles, int h) const;

  static Frame halfedge_in_plane(const Intrinsic_triangulation& triangles, int h);

  /// Applies the rigid motion that maps one frame to the other
  static void move(std::vector<Piece>& pieces, const Frame& from, const Frame& to);

  /// Clips the pieces to the left side of the line from p to q. Drops slivers along the line that
  /// are due to rounding, unless nothing else is left.
  static std::vector<Piece> left_of(const std::vector<Piece>& pieces, const Eigen::Vector2d& p,
                                    const Eigen::Vector2d& q);
  void add_face(const Mesh_view& mesh, const Intrinsic_triangulation& triangles, int f);

  std::vector<std::vector<Piece>> m_pieces;  // of each intrinsic face
  std::size_t m_size = 0;
};

}  // namespace internal

/// \ingroup PkgMesh
/// \brief the surface of robust operators: functions are linear on the triangles of the intrinsic
/// Delaunay triangulation, and the tangent planes are those of the faces of the mesh.
///
/// A model of `ConformalSurface`: each face that a triangle passes through is a `Sheet` of the
/// triangle. If the mesh is Delaunay already, each triangle is a face with a single sheet. Cotan
/// weights (`cotan_weights()`) are at least half the cotangent of 150 degrees, and in the interior
/// not negative, except on the sides of caps.
///
/// Faces may have area zero, and points may coincide: the length that edges lack to form triangles
/// is added to all edges (`mollified_lengths()`). Usually O(|V| + |F|); the number of sheets is
/// that of the faces plus a few for each flip. It could be quadratic, and has a limit.
///
/// Boundary edges are never flipped. A cap along one (`boundary_caps()`) is split into two
/// triangles, left and right of its height, both ends of which are the same vertex.
class Delaunay_view {
 public:
  /// \param mesh an oriented manifold with finite coordinates and more than one point
  /// \param mollification see `mollified_lengths()`
  /// \param forms closed 1-forms of the mesh, |E| x k, to be transferred: temporarily needs three
  /// times their memory, and O(k) for every flip; empty: none
  /// \throw Precondition_error if there were more than 100 sheets per face, because long thin faces
  /// wind about each other: try a mesh without needles
  explicit Delaunay_view(const Mesh_view& mesh, double mollification = 1e-6,
                         const Eigen::MatrixXd& forms = {});

  int size_of_vertices() const { return static_cast<int>(m_positions.cols()); }
  int size_of_triangles() const { return m_sheets.empty() ? 0 : m_sheets.back().triangle + 1; }
  int size_of_faces() const { return m_size_of_faces; }  ///< of the mesh
  const Points& positions() const { return m_positions; }
  Eigen::Vector3d position(int v) const { return m_positions.col(v); }

  /// number of edges that are not edges of the mesh, or were flipped away and back
  int number_of_flips() const { return m_flips; }

  /// number of faces of the mesh whose edges formed no triangle, or nearly none
  int number_of_thin_faces() const { return m_thin_faces; }

  /// the length that was added to every edge to form triangles
  double added_length() const { return m_added_length; }

  /// ordered by triangle
  const std::vector<Sheet>& sheets() const { return m_sheets; }
  int size_of_sheets() const { return static_cast<int>(m_sheets.size()); }
  const Sheet& sheet(int i) const { return m_sheets[index(i)]; }

  int size_of_edges() const { return static_cast<int>(m_ends.size()); }

  /// the vertices that edge k joins, the smaller number first; they may coincide, or be those of
  /// another edge
  const std::array<int, 2>& ends(int k) const { return m_ends[index(k)]; }

  /// the ends of all edges
  const std::vector<std::array<int, 2>>& ends() const { return m_ends; }

  /// the transferred forms along the edges, `size_of_edges()` x k
  const Eigen::MatrixXd& forms() const { return m_forms; }

  /// the boundary loops of the mesh
  const std::vector<std::vector<int>>& boundary_loops() const { return m_loops; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// Numbers the edges without the long edges of caps; returns the number of the edge of each
  /// halfedge, -1 for the long edges of caps.
  std::vector<int> number_edges(const internal::Intrinsic_triangulation& triangles,
                                const std::vector<int>& caps,
                                const internal::Transported_forms& forms);

  /// \param cap the halfedge opposite the angle of a cap, or -1
  /// \param edges of all halfedges
  void add_face(const internal::Intrinsic_triangulation& triangles, int t, int cap,
                const std::vector<int>& edges,
                const std::vector<internal::Common_subdivision::Piece>& pieces);

  /// \param triangle with corners, edges and area
  /// \param p the corners in its plane
  void add_triangle(Sheet triangle, const Eigen::Matrix<double, 2, 3>& p,
                    const std::vector<internal::Common_subdivision::Piece>& pieces);

  Points m_positions;
  int m_size_of_faces;
  std::vector<std::vector<int>> m_loops;
  std::vector<Sheet> m_sheets;
  std::vector<std::array<int, 2>> m_ends;
  Eigen::MatrixXd m_forms;
  int m_flips = 0, m_thin_faces = 0;
  double m_added_length = 0;
};

/// \ingroup PkgMesh
/// the boundary loops of the mesh
inline const std::vector<std::vector<int>>& boundary_loops(const Delaunay_view& view)
{
  return view.boundary_loops();
}

}  // namespace Conformal_geometry_processing
