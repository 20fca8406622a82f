// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_SUPPORT_MESH_TOOLS_H
#define TEST_SUPPORT_MESH_TOOLS_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>

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
inline Points points(const std::vector<std::array<double, 3>>& list)
{
  Points p(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    p.col(static_cast<Eigen::Index>(i)) << list[i][0], list[i][1], list[i][2];
  return p;
}

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

inline Mesh_view scaled(const Mesh_view& mesh, double factor)
{
  return {factor * mesh.positions(), mesh.corners()};
}

inline double area(const Mesh_view& mesh)
{
  double sum = 0;
  for (const auto& v : mesh.corners()) {
    const Eigen::Vector3d a = mesh.position(v[1]) - mesh.position(v[0]);
    const Eigen::Vector3d b = mesh.position(v[2]) - mesh.position(v[0]);
    sum += a.cross(b).norm() / 2;
  }
  return sum;
}

inline Mesh_view scaled_to_area(const Mesh_view& mesh, double wanted)
{
  return scaled(mesh, std::sqrt(wanted / area(mesh)));
}

using Conformal_geometry_processing::mean_edge_length;

/// the same surface with its normals turned around
inline Mesh_view with_reversed_faces(const Mesh_view& mesh)
{
  Corners corners = mesh.corners();
  for (auto& v : corners) std::swap(v[1], v[2]);
  return {mesh.positions(), std::move(corners)};
}

/// vertex v becomes vertex new_number[v]
inline Mesh_view renumbered(const Mesh_view& mesh, const std::vector<int>& new_number)
{
  Points p(3, mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) p.col(new_number[at(v)]) = mesh.position(v);
  Corners corners = mesh.corners();
  for (auto& face : corners)
    for (int& v : face) v = new_number[at(v)];
  return {std::move(p), std::move(corners)};
}

/// both meshes as one, the second moved by `offset`; its vertices and faces come last
inline Mesh_view disjoint_union(const Mesh_view& a, const Mesh_view& b,
                                const Eigen::Vector3d& offset)
{
  const int n = a.size_of_vertices();
  Points p(3, n + b.size_of_vertices());
  p << a.positions(), b.positions().colwise() + offset;
  Corners corners = a.corners();
  for (const auto& v : b.corners()) corners.push_back({v[0] + n, v[1] + n, v[2] + n});
  return {std::move(p), std::move(corners)};
}

/// the mesh without the face f; vertices stay
inline Mesh_view without_face(const Mesh_view& mesh, int f)
{
  Corners corners = mesh.corners();
  corners.erase(corners.begin() + f);
  return {mesh.positions(), std::move(corners)};
}

/// each face becomes four; vertex |V| + k is the midpoint of edge k
inline Mesh_view subdivided(const Mesh_view& mesh)
{
  const int n = mesh.size_of_vertices();
  Points p(3, n + mesh.size_of_edges());
  p.leftCols(n) = mesh.positions();
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    p.col(n + k) = (mesh.position(mesh.ends(k)[0]) + mesh.position(mesh.ends(k)[1])) / 2;
  Corners corners;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const int a = n + mesh.edge(3 * f), b = n + mesh.edge(3 * f + 1), c = n + mesh.edge(3 * f + 2);
    corners.insert(corners.end(), {{v[0], c, b}, {v[1], a, c}, {v[2], b, a}, {a, b, c}});
  }
  return {std::move(p), std::move(corners)};
}

/// the exponent p of error = const h^p: slope of the regression line of the logarithms
inline double slope(const std::vector<double>& h, const std::vector<double>& error)
{
  const auto n = static_cast<Eigen::Index>(h.size());
  Eigen::ArrayXd x = Eigen::ArrayXd::Map(h.data(), n).log();
  Eigen::ArrayXd y = Eigen::ArrayXd::Map(error.data(), n).abs().log();
  x -= x.mean();
  y -= y.mean();
  return (x * y).sum() / (x * x).sum();
}

}  // namespace cgp_test

#endif
