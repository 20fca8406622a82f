// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_VIEW_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_VIEW_H

#include <Conformal_geometry_processing/mesh/Common_subdivision.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Transported_forms.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief a surface as robust operators see it: functions are linear on the triangles of its
/// intrinsic Delaunay triangulation, the tangent planes are those of the faces of the mesh.
///
/// The planes of the faces that a triangle passes through are its `Sheet`s: the triangle laid out
/// in the plane of that face, with the share of the triangle's area that lies in it. What is
/// assembled from sheets with their shares is the integral over the surface of what is assembled
/// from faces otherwise. Where the mesh is Delaunay already, each triangle is a face of it, and its
/// own only sheet.
///
/// Faces may have area zero, and points may coincide: what the lengths of edges lack to form
/// triangles is added to all (`mollified_lengths()`). O(|V| + |F|) as a rule; the number of sheets
/// is that of the faces and a few for each flip, but quadratic in the worst case.
///
/// The edges of the boundary are never flipped. A cap along one (`boundary_caps()`) is two
/// triangles, left and right of its height, of which both ends are the same vertex.
class Delaunay_view {
 public:
  /// a triangle of the triangulation in the plane of a face
  struct Sheet {
    int triangle;
    int face;               ///< of the mesh
    double share;           ///< of the area of the triangle; those of a triangle add up to 1
    Eigen::Matrix3d edges;  ///< column c is the edge opposite corner c, as in a face
  };

  /// \param mesh an oriented manifold with finite coordinates and more than one point
  /// \param mollification see `mollified_lengths()`
  /// \param forms closed 1-forms of the mesh, |E| x k, to be taken along: three times their memory
  /// for a while, and O(k) for every flip; empty: none
  explicit Delaunay_view(const Mesh_view& mesh, double mollification = 1e-6,
                         const Eigen::MatrixXd& forms = {});

  int size_of_vertices() const { return static_cast<int>(m_positions.cols()); }
  int size_of_triangles() const { return static_cast<int>(m_corners.size()); }
  int size_of_faces() const { return m_size_of_faces; }  ///< of the mesh
  const Points& positions() const { return m_positions; }
  Eigen::Vector3d position(int v) const { return m_positions.col(v); }

  /// how many edges are not those of the mesh, or have been others meanwhile
  int number_of_flips() const { return m_flips; }

  /// how many faces of the mesh had edges that formed no triangle, or nearly none
  int number_of_thin_faces() const { return m_thin_faces; }

  /// what was added to the length of every edge therefore
  double added_length() const { return m_added_length; }

  /// the vertices of triangle t, counter-clockwise; the same one may come twice, in the halves of a
  /// cap and where an edge leads around a spike back to where it began
  const std::array<int, 3>& corners(int t) const { return m_corners[index(t)]; }
  double area(int t) const { return m_areas[index(t)]; }

  /// of the angle of triangle t at corner c
  double cotangent(int t, int c) const { return m_cotangents[index(3 * t + c)]; }

  /// ordered by triangle
  const std::vector<Sheet>& sheets() const { return m_sheets; }

  int size_of_edges() const { return static_cast<int>(m_ends.size()); }

  /// the vertices that edge k joins, the smaller number first; they may be the same, or those of
  /// another edge
  const std::array<int, 2>& ends(int k) const { return m_ends[index(k)]; }

  /// \brief half the sum of the cotangents opposite each edge, |E|; of the sides of a cap, those of
  /// its halves. At least half the cotangent of 150 degrees, and not negative inside, but for the
  /// sides of caps.
  const Eigen::VectorXd& cotan_weights() const { return m_weights; }

  /// the forms along the edges, `size_of_edges()` x k
  const Eigen::MatrixXd& forms() const { return m_forms; }

  /// of the mesh
  const std::vector<std::vector<int>>& boundary_loops() const { return m_loops; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// \param cap the halfedge opposite the angle of a cap, or -1
  void add_face(const Intrinsic_triangulation& triangles, int t, int cap,
                const std::vector<Common_subdivision::Piece>& pieces);

  /// \param p the corners in the plane of the intrinsic face
  void add_triangle(const std::array<int, 3>& corners, const Eigen::Matrix<double, 2, 3>& p,
                    double area, const Eigen::Vector3d& cotangents,
                    const std::vector<Common_subdivision::Piece>& pieces);

  /// What a triangle contributes to the weight of the edge of h: where it is a cap, its two halves
  /// have their right angles at the long edge, which is none of theirs.
  static double half_weight(const Intrinsic_triangulation& triangles, int h, int cap);
  void add_edges(const Intrinsic_triangulation& triangles, const std::vector<int>& caps,
                 const Transported_forms& forms);

  Points m_positions;
  int m_size_of_faces;
  std::vector<std::vector<int>> m_loops;
  std::vector<std::array<int, 3>> m_corners;
  std::vector<double> m_areas, m_cotangents;
  std::vector<Sheet> m_sheets;
  std::vector<std::array<int, 2>> m_ends;
  Eigen::VectorXd m_weights;
  Eigen::MatrixXd m_forms;
  int m_flips = 0, m_thin_faces = 0;
  double m_added_length = 0;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/Delaunay_view_impl.h>
#endif

#endif
