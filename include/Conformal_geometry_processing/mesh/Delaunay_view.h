// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_VIEW_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_VIEW_H

#include <Conformal_geometry_processing/mesh/Common_subdivision.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/intrinsic_delaunay.h>
#include <Conformal_geometry_processing/mesh/mollified_lengths.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <utility>
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
  explicit Delaunay_view(const Mesh_view& mesh, double mollification = 1e-6)
      : m_positions(mesh.positions())
  {
    Intrinsic_triangulation triangles(mesh, mollified_lengths(mesh, mollification));
    Common_subdivision subdivision(mesh, triangles);
    m_flips = flip_to_delaunay(triangles, [&](int h) { subdivision.before_flip(triangles, h); });
    for (int t = 0; t < triangles.size_of_faces(); ++t) {
      m_corners.push_back(
          {triangles.apex(3 * t), triangles.apex(3 * t + 1), triangles.apex(3 * t + 2)});
      m_areas.push_back(triangles.area(t));
      for (int h = 3 * t; h < 3 * t + 3; ++h) m_cotangents.push_back(triangles.cotangent(h));
      add_sheets(triangles, t, subdivision.pieces(t));
    }
  }

  int size_of_vertices() const { return static_cast<int>(m_positions.cols()); }
  int size_of_triangles() const { return static_cast<int>(m_corners.size()); }
  const Points& positions() const { return m_positions; }

  /// how many edges are not those of the mesh, or have been others meanwhile
  int size_of_flips() const { return m_flips; }

  /// the vertices of triangle t, counter-clockwise; the same one may come twice
  const std::array<int, 3>& corners(int t) const { return m_corners[index(t)]; }
  double area(int t) const { return m_areas[index(t)]; }

  /// of the angle of triangle t at corner c
  double cotangent(int t, int c) const { return m_cotangents[index(3 * t + c)]; }

  /// ordered by triangle
  const std::vector<Sheet>& sheets() const { return m_sheets; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void add_sheets(const Intrinsic_triangulation& triangles, int t,
                  const std::vector<Common_subdivision::Piece>& pieces)
  {
    const Eigen::Vector2d apex = triangles.apex_in_plane(3 * t), right(triangles.length(3 * t), 0);
    Eigen::Matrix<double, 2, 3> edges;
    edges << right, apex - right, -apex;
    double total = 0;
    for (const auto& piece : pieces) total += piece.weight;
    for (const auto& piece : pieces)
      m_sheets.push_back({t, piece.face, piece.weight / total, piece.to_space * edges});
  }

  Points m_positions;
  std::vector<std::array<int, 3>> m_corners;
  std::vector<double> m_areas, m_cotangents;
  std::vector<Sheet> m_sheets;
  int m_flips = 0;
};

}  // namespace Conformal_geometry_processing

#endif
