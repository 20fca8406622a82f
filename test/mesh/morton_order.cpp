// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests mesh/Mesh_component.h
#include <Conformal_geometry_processing/mesh/Mesh_component.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "support/mesh_tools.h"
#include "support/random.h"
#include "support/spheres.h"

namespace cgp_test::morton_order_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Mesh_component;

Mesh_component whole(const Mesh_view& mesh)
{
  Mesh_component all{mesh, {}, {}};
  all.vertices.resize(static_cast<std::size_t>(mesh.size_of_vertices()));
  all.faces.resize(static_cast<std::size_t>(mesh.size_of_faces()));
  std::iota(all.vertices.begin(), all.vertices.end(), 0);
  std::iota(all.faces.begin(), all.faces.end(), 0);
  return all;
}

Mesh_component ordered(const Mesh_view& mesh)
{
  return CGP::internal::in_morton_order(whole(mesh));
}

/// with other numbers of vertices and faces, and other first corners
Mesh_view shuffled(const Mesh_view& mesh)
{
  const Mesh_view other = renumbered(mesh, random_permutation(mesh.size_of_vertices(), 7));
  Mesh_view::Corners corners;
  for (const int f : random_permutation(mesh.size_of_faces(), 8)) {
    corners.push_back(other.corners(f));
    std::rotate(corners.back().begin(), corners.back().begin() + f % 3, corners.back().end());
  }
  return {other.positions(), corners};
}

/// the mean distance in memory of neighbours
double mean_distance(const Mesh_view& mesh)
{
  double sum = 0;
  for (const auto& ends : mesh.ends()) sum += std::abs(ends[0] - ends[1]);
  return sum / mesh.size_of_edges();
}

Mesh_view surface()
{
  return perturbed(icosphere(3), .05);
}

TEST(Morton_order, is_the_same_for_any_numbering)
{
  const Mesh_component one = ordered(surface()), other = ordered(shuffled(surface()));
  EXPECT_EQ(one.mesh.positions(), other.mesh.positions());
  EXPECT_EQ(one.mesh.corners(), other.mesh.corners());
}

// As at seams: vertices at one position differ by their neighbours.
TEST(Morton_order, is_the_same_where_vertices_coincide)
{
  const Mesh_view a = surface();
  CGP::Points moved = perturbed(a, .1, 5).positions();
  for (const int v : {3, 50, 51}) moved.col(v) = a.position(v);
  const Mesh_view pair = disjoint_union(a, {moved, a.corners()}, Eigen::Vector3d::Zero());
  const Mesh_component one = ordered(pair), other = ordered(shuffled(pair));
  EXPECT_EQ(one.mesh.positions(), other.mesh.positions());
  EXPECT_EQ(one.mesh.corners(), other.mesh.corners());
}

TEST(Morton_order, leads_back_to_the_elements_of_the_whole)
{
  const Mesh_view mesh = shuffled(surface());
  Mesh_component all = whole(mesh);
  for (int& v : all.vertices) v += 100;  // as a part of something larger
  const Mesh_component part = CGP::internal::in_morton_order(all);
  std::vector<int> seen = part.faces;
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(seen, all.faces);
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    std::array<int, 3> before = mesh.corners(part.faces[static_cast<std::size_t>(f)]), now{};
    for (std::size_t c = 0; c < 3; ++c)
      now[c] = part.vertices[static_cast<std::size_t>(part.mesh.corners(f)[c])] - 100;
    std::rotate(before.begin(), std::find(before.begin(), before.end(), now[0]), before.end());
    EXPECT_EQ(now, before);
  }
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    EXPECT_EQ(part.mesh.position(v),
              mesh.position(part.vertices[static_cast<std::size_t>(v)] - 100));
}

// Along the curve neighbours are about the root of their number apart, shuffled a third of it.
TEST(Morton_order, brings_neighbours_together)
{
  const Mesh_view mesh = shuffled(icosphere(4));
  const double n = mesh.size_of_vertices();
  EXPECT_GT(mean_distance(mesh), n / 4);
  EXPECT_LT(mean_distance(ordered(mesh).mesh), 4 * std::sqrt(n));
}

TEST(Morton_order, takes_any_unit_of_length_and_vertices_at_one_place)
{
  const Mesh_view mesh = surface();
  for (const double unit : {1e-300, 1e307}) {
    const Mesh_view scaled =
        mapped(mesh, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(unit * p); });
    EXPECT_LT(mean_distance(ordered(scaled).mesh), 4 * std::sqrt(mesh.size_of_vertices()));
  }
  const Mesh_view point(CGP::Points::Zero(3, 4), {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(ordered(point).vertices, (std::vector<int>{1, 3, 0, 2}));  // fewer neighbours first
  EXPECT_TRUE(ordered(Mesh_view()).vertices.empty());
}

}  // namespace cgp_test::morton_order_tests
