// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
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
    std::vector<Eigen::Vector2d> polygon;
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
  static double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
  static double area(const std::vector<Eigen::Vector2d>& polygon);
  static std::vector<Eigen::Vector2d> left_of(const std::vector<Eigen::Vector2d>& polygon,
                                              const Eigen::Vector2d& p, const Eigen::Vector2d& q);

  /// Clips the pieces to the left side of the line from p to q. Drops slivers along the line that
  /// are due to rounding, unless nothing else is left.
  static std::vector<Piece> left_of(const std::vector<Piece>& pieces, const Eigen::Vector2d& p,
                                    const Eigen::Vector2d& q);
  void add_face(const Mesh_view& mesh, const Intrinsic_triangulation& triangles, int f);

  std::vector<std::vector<Piece>> m_pieces;  // of each intrinsic face
  std::size_t m_size = 0;
};

}  // namespace Conformal_geometry_processing::internal
