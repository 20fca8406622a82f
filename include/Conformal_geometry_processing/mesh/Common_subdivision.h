// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_COMMON_SUBDIVISION_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_COMMON_SUBDIVISION_H

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief which parts of the faces of a mesh lie in which face of its intrinsic triangulation, and
/// how they stand in space.
///
/// Follows the flips: the pieces of two triangles, laid out in the plane, are cut along the new
/// diagonal. Rounding shifts the cuts a little, but whatever it does, each intrinsic face has
/// pieces with positive weights.
class Common_subdivision {
 public:
  /// a convex part of a face, in the plane of the intrinsic face in which it lies: there halfedge
  /// 3 g runs from (0, 0) along the x-axis
  struct Piece {
    std::vector<Eigen::Vector2d> polygon;
    double weight;                         ///< its area in the mesh
    int face;                              ///< of the mesh
    Eigen::Matrix<double, 3, 2> to_space;  ///< an isometry from that plane to the plane of the face
  };

  /// \param mesh the one whose faces the triangles still are
  Common_subdivision(const Mesh_view& mesh, const Intrinsic_triangulation& triangles);
  const std::vector<Piece>& pieces(int face) const;

  /// \pre the edge of h will be flipped, and has not been yet
  void before_flip(const Intrinsic_triangulation& triangles, int h);

 private:
  /// a point and a unit vector
  struct Frame {
    Eigen::Vector2d origin, direction;

    Eigen::Matrix2d rotation() const;
  };

  static Frame halfedge_in_plane(const Intrinsic_triangulation& triangles, int h);

  /// the rigid motion that takes the one frame to the other
  static void move(std::vector<Piece>& pieces, const Frame& from, const Frame& to);
  static double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
  static double area(const std::vector<Eigen::Vector2d>& polygon);
  static std::vector<Eigen::Vector2d> left_of(const std::vector<Eigen::Vector2d>& polygon,
                                              const Eigen::Vector2d& p, const Eigen::Vector2d& q);

  /// What is left of the line from p to q. Splinters that rounding leaves along the line are
  /// dropped, as long as there is something else.
  static std::vector<Piece> left_of(const std::vector<Piece>& pieces, const Eigen::Vector2d& p,
                                    const Eigen::Vector2d& q);
  void add_face(const Mesh_view& mesh, const Intrinsic_triangulation& triangles, int f);

  std::vector<std::vector<Piece>> m_pieces;  // of each intrinsic face
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/Common_subdivision_impl.h>
#endif

#endif
