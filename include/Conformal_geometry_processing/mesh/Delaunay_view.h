// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Common_subdivision.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Transported_forms.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

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
