// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>

/// \file requirements.h
/// \brief Requirements on meshes, checked before anything is assembled.
///
/// Each function throws `Precondition_error` in the name of `function`; the message contains the
/// number of offending elements, the first of them, and the requirement. Numbers count from 0.
namespace Conformal_geometry_processing {

/// A face is rejected if its area is below this multiple of its squared longest edge, because its
/// normal is then determined by the rounding of the coordinates
constexpr double relative_area_tolerance = 1e-13;

namespace internal {

std::string name_of_face(const Mesh_view& mesh, int f);

std::string name_of_edge(const Mesh_view& mesh, int k);

/// Returns "1 face of area zero", "3 faces of area zero" for what = "#face of area zero"
std::string counted(int count, std::string what);

/// Returns whether a triangle with these vectors along its edges, one per column, has area zero
/// relative to the longest (`relative_area_tolerance`)
bool has_area_zero(Eigen::Matrix3d edges);

/// The elements that violate a requirement
struct Defect {
  enum class Kind {
    vertex_out_of_range,  ///< of coordinates
    non_manifold_edge,
    edge_of_opposed_faces,
    non_manifold_vertex,
    face_of_area_zero,
    further_component,  ///< named by its first vertex
    boundary_edge
  };

  Kind kind;
  int count = 0;   ///< none: the requirement holds
  int first = -1;  ///< index of the first one

  explicit operator bool() const { return count > 0; }

  /// Adds those of larger index
  Defect& operator+=(const Defect& later)
  {
    if (count == 0) first = later.first;
    count += later.count;
    return *this;
  }
};

/// Counts the i in [0, n) with `is_bad(i)`, on several threads
template <class Is_bad>
Defect find_defect(Defect::Kind kind, int n, const Is_bad& is_bad)
{
  const std::ptrdiff_t at_once = 4096, least = 2;
  const auto add = [&is_bad](std::ptrdiff_t begin, std::ptrdiff_t end, Defect& defect) {
    for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
      if (is_bad(i) && defect.count++ == 0) defect.first = i;
  };
  return sum_of_ranges(n, at_once, Defect{kind}, add, least);
}

// What the requirements below look for.
Defect non_finite_vertices(const Mesh_view& mesh);
Defect non_manifold_edges(const Mesh_view& mesh);
Defect edges_of_opposed_faces(const Mesh_view& mesh);
Defect non_manifold_vertices(const Mesh_view& mesh);
Defect faces_of_area_zero(const Mesh_view& mesh);
Defect further_components(const Mesh_view& mesh);
Defect boundary_edges(const Mesh_view& mesh);

/// Throws if `is_bad(i)` for an i in [0, n): "3 faces of area zero, the first is face 7 (...)"
/// \param what has a # before the noun to be put in the plural
template <class Is_bad, class Name_of>
void refuse_if_any(int n, Is_bad is_bad, Name_of name_of, const std::string& function,
                   const std::string& what, const std::string& advice)
{
  int first = -1, count = 0;
  for (int i = 0; i < n; ++i)
    if (is_bad(i) && count++ == 0) first = i;
  if (count > 0)
    throw Precondition_error(
        function, counted(count, what) + ", the first is " + name_of(first) + "; " + advice);
}

std::string name_of_vertex(int v);

/// A mesh without its thinnest faces
struct Well_shaped_faces {
  Mesh_view mesh;    ///< all vertices, and the remaining faces
  double share = 0;  ///< of the remaining faces in the area of the mesh
};

}  // namespace internal

/// Requires at least one face
void require_not_empty(const Mesh_view& mesh, const std::string& function);

/// Requires finite coordinates
void require_finite_positions(const Mesh_view& mesh, const std::string& function);

/// Requires that every vertex belongs to a face
void require_no_isolated_vertices(const Mesh_view& mesh, const std::string& function);

/// Requires that the three corners of every face are different vertices
void require_distinct_corners(const Mesh_view& mesh, const std::string& function);

/// Requires that at most two faces meet along an edge, in opposite directions
void require_manifold_edges(const Mesh_view& mesh, const std::string& function);

/// Requires that the faces around every vertex form one fan
void require_manifold_vertices(const Mesh_view& mesh, const std::string& function);

/// Returns whether the area of face f is zero relative to its longest edge
/// (`relative_area_tolerance`)
bool has_area_zero(const Mesh_view& mesh, int f);

/// Requires that no face has area zero
void require_positive_areas(const Mesh_view& mesh, const std::string& function);

/// Requires that not all faces have area zero
void require_some_area(const Mesh_view& mesh, const std::string& function);

/// Requires one component
/// \pre no vertex is isolated
void require_connected(const Mesh_view& mesh, const std::string& function);

/// Requires that there is no boundary
void require_closed(const Mesh_view& mesh, const std::string& function);

/// Requires genus zero
/// \pre the mesh is a closed, connected manifold
void require_genus_zero(const Mesh_view& mesh, const std::string& function);

/// Requires a finite, oriented manifold in one component or more, without isolated vertices; faces
/// may have area zero
void require_manifold_components(const Mesh_view& mesh, const std::string& function);

/// Requires a manifold as above, in one component
void require_manifold(const Mesh_view& mesh, const std::string& function);

/// Requirements of most algorithms: `require_manifold()`, and no faces of area zero
void require_surface(const Mesh_view& mesh, const std::string& function);

/// \ingroup PkgMesh
/// \brief Removes the thinnest faces, needles and caps of three degrees or less, but no more than
/// 5 % of the area.
///
/// If the height of a face is less than 5 % of its longest edge, small errors of its corners
/// determine its shape; as long as such faces are few, their distortion says nothing about a map.
/// Faces of area zero are always removed. O(|F| log |F|).
internal::Well_shaped_faces well_shaped_faces(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
