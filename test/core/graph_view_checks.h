// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "support/meshes.h"

/// What every mesh type must fulfil, one test file for each.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

using Triangle = std::array<std::array<double, 3>, 3>;

/// the faces as their points, independent of the order of the elements and of the first corner
inline std::vector<Triangle> sorted_triangles(const Mesh_view& mesh)
{
  std::vector<Triangle> triangles;
  for (const auto& face : mesh.corners()) {
    Triangle t;
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d p = mesh.position(face[c]);
      t[c] = {p.x(), p.y(), p.z()};
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

template <class Mesh, class NamedParameters = CGP::parameters::Default_named_parameters>
CGP::Graph_view<Mesh> graph_view(const Mesh& mesh, const NamedParameters& np = {})
{
  return {mesh, np, "graph_view"};
}

/// The mesh has the faces of `expected`, and the view is numbered in the order of the ranges
template <class Mesh>
void expect_view_of(const Mesh_view& expected, const Mesh& mesh)
{
  const CGP::Graph_view<Mesh> graph = graph_view(mesh);
  EXPECT_EQ(graph.view().size_of_vertices(), expected.size_of_vertices());
  EXPECT_EQ(graph.view().size_of_edges(), expected.size_of_edges());
  EXPECT_EQ(sorted_triangles(graph.view()), sorted_triangles(expected));
  int v = 0, f = 0;
  for (auto vertex : vertices(mesh)) EXPECT_TRUE(graph.vertex(v++) == vertex);
  for (auto face : faces(mesh)) EXPECT_TRUE(graph.face(f++) == face);
}

/// positions that are exact in float arrive in the mesh, and are read from there
template <class Mesh>
void expect_positions_are_written(Mesh& mesh)
{
  const CGP::Graph_view<Mesh> graph = graph_view(mesh);
  const Points moved = 2 * graph.view().positions().array() + 1;
  const auto np = CGP::parameters::default_values();
  graph.write_positions(moved, CGP::internal::output_vertex_points(mesh, np),
                        CGP::internal::geometry_traits<Mesh>(np));
  EXPECT_EQ(graph_view(mesh).view().positions(), moved);
}

/// Returns the message of the exception for an unsuitable mesh
template <class Mesh>
std::string refusal(const Mesh& mesh)
{
  try {
    graph_view(mesh);
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace cgp_test
