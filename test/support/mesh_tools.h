// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// Meshes made from other meshes, and what tests measure without the code under test.
namespace cgp_test {

using Conformal_geometry_processing::Mesh_view;
using Conformal_geometry_processing::Points;
using Corners = Mesh_view::Corners;

constexpr double pi = 3.14159265358979323846;

inline std::size_t at(int i)
{
  return static_cast<std::size_t>(i);
}

/// points given one per row of a list
Points points(const std::vector<std::array<double, 3>>& list);

/// Replaces every point p by map(p), a `Vector3d`, because an expression could dangle
template <class Map>
Mesh_view mapped(const Mesh_view& mesh, Map map)
{
  static_assert(std::is_same_v<decltype(map(Eigen::Vector3d())), Eigen::Vector3d>);
  Points p = mesh.positions();
  for (Eigen::Index v = 0; v < p.cols(); ++v) {
    const Eigen::Vector3d before = p.col(v);
    p.col(v) = map(before);
  }
  return {std::move(p), mesh.corners()};
}

Mesh_view scaled(const Mesh_view& mesh, double factor);

double area(const Mesh_view& mesh);

Mesh_view scaled_to_area(const Mesh_view& mesh, double wanted);

using Conformal_geometry_processing::mean_edge_length;

/// the same surface with its normals turned around
Mesh_view with_reversed_faces(const Mesh_view& mesh);

/// vertex v becomes vertex new_number[v]
Mesh_view renumbered(const Mesh_view& mesh, const std::vector<int>& new_number);

/// both meshes as one, the second moved by `offset`; its vertices and faces come last
Mesh_view disjoint_union(const Mesh_view& a, const Mesh_view& b, const Eigen::Vector3d& offset);

/// the mesh without the face f; vertices stay
Mesh_view without_face(const Mesh_view& mesh, int f);

/// each face becomes four; vertex |V| + k is the midpoint of edge k
Mesh_view subdivided(const Mesh_view& mesh);

/// the exponent p of error = const h^p: slope of the regression line of the logarithms
double slope(const std::vector<double>& h, const std::vector<double>& error);

}  // namespace cgp_test
