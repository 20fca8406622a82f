// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_structure.h>
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/graphs.h"
#include "quaternionic_linear_algebra/threads/threads.h"
#include "support/spheres.h"

namespace cgp_test::sweep_nested_dissection_tests {

using CGP::internal::Side;

int size_of(const std::vector<Side>& sides, Side side)
{
  return static_cast<int>(std::count(sides.begin(), sides.end(), side));
}

std::vector<Side> sides_of(int n, const Edges& edges, const Eigen::Matrix3Xd& positions)
{
  return CGP::internal::Sweep_cut()(CGP::graph_region(pattern_of(n, edges), positions));
}

TEST(Sweep_cut, leaves_a_quarter_on_either_side)
{
  for (int n : {2, 3, 4, 10, 100, 1000}) {
    const auto sides = sides_of(n, random_edges(n, 2 * n, 1), random_positions(n, 2));
    EXPECT_GE(size_of(sides, Side::left), n / 4) << n;
    EXPECT_GE(size_of(sides, Side::right), n / 4) << n;
  }
}

// A row of 40 x 10 vertices that only one edge joins to a row of 24 x 10 vertices.
TEST(Sweep_cut, finds_the_neck_away_from_the_middle)
{
  Eigen::Matrix3Xd p(3, 640);
  Edges edges;
  for (int k = 0; k < 640; ++k) {
    p.col(k) << k / 10, k % 10, 0;
    if (k % 10 < 9) edges.push_back({k, k + 1});
    if (k < 630 && (k / 10 != 39 || k % 10 == 5)) edges.push_back({k, k + 10});
  }
  const auto sides = sides_of(640, edges, p);
  const Side first = sides.front(), last = sides.back();
  EXPECT_NE(first, last);
  for (int k = 0; k < 640; ++k) {
    EXPECT_TRUE(sides[at(k)] == Side::separator || sides[at(k)] == (k < 400 ? first : last));
  }
}

// All cuts across a strip are equal except for the sizes of the parts.
TEST(Sweep_cut, of_a_strip_is_in_the_middle)
{
  Eigen::Matrix3Xd p(3, 800);
  Edges edges;
  for (int k = 0; k < 800; ++k) {
    p.col(k) << k / 4, k % 4, 0;
    if (k % 4 < 3) edges.push_back({k, k + 1});
    if (k < 796) edges.push_back({k, k + 4});
  }
  const auto sides = sides_of(800, edges, p);
  EXPECT_NEAR(size_of(sides, Side::left), size_of(sides, Side::right), 16);
}

TEST(Sweep_cut, halves_vertices_that_coincide)
{
  const int n = 101;
  const auto sides = sides_of(n, path_edges(n), Eigen::Matrix3Xd::Zero(3, n));
  EXPECT_EQ(size_of(sides, Side::left), 50);
  EXPECT_EQ(size_of(sides, Side::right), 51);
}

TEST(Sweep_cut, halves_where_most_vertices_coincide)
{
  const int n = 100;
  Eigen::Matrix3Xd p = Eigen::Matrix3Xd::Zero(3, n);
  p.col(0) << 1, 2, 3;
  p.col(99) << -1, 0, 5;
  const auto sides = sides_of(n, path_edges(n), p);
  EXPECT_EQ(size_of(sides, Side::left), 50);
  EXPECT_EQ(size_of(sides, Side::right), 50);
}

double operations(const CGP::Sparse_pattern& pattern, const CGP::internal::Ordering& order)
{
  return CGP::internal::Supernodal_structure(pattern, order).operations();
}

double sweep_operations(const Mesh_view& mesh)
{
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  return operations(pattern, CGP::sweep_nested_dissection(pattern, mesh.positions()));
}

void expect_permutation(int n, const CGP::internal::Ordering& order, const std::string& name)
{
  EXPECT_EQ(static_cast<int>(order.size()), n) << name;
  EXPECT_EQ(CGP::inverse_permutation(order).size(), order.size()) << name;
}

TEST(Sweep_nested_dissection, permutes_the_vertices_of_any_graph_at_any_positions)
{
  for (const Named_graph& graph : graphs_of_all_kinds()) {
    const int n = graph.size;
    const CGP::Sparse_pattern pattern = pattern_of(n, graph.edges);
    Eigen::Matrix3Xd line = Eigen::Matrix3Xd::Zero(3, n), outlier = line;
    for (int k = 0; k < n; ++k) line(1, k) = k;
    if (n > 0) outlier(0, 0) = 1e9;
    for (const Eigen::Matrix3Xd& p :
         {random_positions(n, 4), Eigen::Matrix3Xd(3e-300 * random_positions(n, 4)),
          Eigen::Matrix3Xd(1e300 * random_positions(n, 4)), Eigen::Matrix3Xd::Zero(3, n).eval(),
          line, outlier})
      expect_permutation(n, CGP::sweep_nested_dissection(pattern, p), graph.name);
  }
}

// George 1973: dissection of a grid needs O(n^(3/2)) operations, elimination row by row O(n^2).
TEST(Sweep_nested_dissection, needs_operations_like_the_power_three_halves_of_the_vertices)
{
  std::vector<double> sizes, counts;
  for (int frequency : {16, 32, 64}) {
    const Mesh_view sphere = geodesic_sphere(frequency);
    sizes.push_back(sphere.size_of_vertices());
    counts.push_back(sweep_operations(sphere));
  }
  EXPECT_LT(slope(sizes, counts), 1.6);
  EXPECT_GT(slope(sizes, counts), 1.4);
}

TEST(Sweep_nested_dissection, beats_minimum_degree_on_regular_spheres)
{
  const Mesh_view sphere = geodesic_sphere(41);
  const CGP::Sparse_pattern pattern = pattern_of(sphere);
  EXPECT_LT(sweep_operations(sphere), 0.7 * operations(pattern, CGP::amd_ordering(pattern)));
}

TEST(Sweep_nested_dissection, keeps_the_given_order_of_a_small_region)
{
  const Mesh_view mesh = geodesic_sphere(5);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  ASSERT_LE(pattern.size(), CGP::max_dissection_leaf);
  const CGP::internal::Ordering given = random_permutation(pattern.size(), 6);
  EXPECT_EQ(CGP::sweep_nested_dissection(pattern, mesh.positions(), given), given);
}

TEST(Sweep_nested_dissection, of_a_chain_fills_in_little)
{
  const int n = 10000;
  Eigen::Matrix3Xd p = Eigen::Matrix3Xd::Zero(3, n);
  for (int k = 0; k < n; ++k) p(0, k) = k;
  const CGP::Sparse_pattern path = pattern_of(n, path_edges(n));
  // At most one entry for each of the two separators around a leaf comes to the two on the band.
  EXPECT_LE(operations(path, CGP::sweep_nested_dissection(path, p)), 3 * 3 * n);
}

TEST(Sweep_nested_dissection, is_the_same_every_time)
{
  const Mesh_view mesh = bumpy_sphere(4);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  EXPECT_EQ(CGP::sweep_nested_dissection(pattern, mesh.positions()),
            CGP::sweep_nested_dissection(pattern, mesh.positions()));
}

TEST(Sweep_nested_dissection, is_the_same_for_any_number_of_threads)
{
  const Mesh_view mesh = geodesic_sphere(21);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  ASSERT_GT(pattern.size(), 4000);  // enough for threads
  const CGP::internal::Ordering expected = CGP::sweep_nested_dissection(pattern, mesh.positions());
  for (const int threads : {2, 3, 8}) {
    const Threads setting(threads);
    EXPECT_EQ(CGP::sweep_nested_dissection(pattern, mesh.positions()), expected);
  }
}

TEST(Sweep_nested_dissection, is_as_good_for_any_numbering)
{
  const Mesh_view mesh = bumpy_sphere(5);
  const double reference = sweep_operations(mesh);
  for (std::uint64_t seed : {1u, 2u, 3u})
    EXPECT_NEAR(
        sweep_operations(renumbered(mesh, random_permutation(mesh.size_of_vertices(), seed))),
        reference, 0.1 * reference);
}

TEST(Sweep_nested_dissection, is_as_good_after_motion_and_scaling)
{
  const Mesh_view mesh = mapped(bumpy_sphere(5), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(1.5 * p.x(), 1.2 * p.y(), p.z());
  });
  const double reference = sweep_operations(mesh);
  Random random(5);
  for (double scale : {1e-30, 1., 1e30}) {
    const Eigen::Matrix3d R = random.rotation();
    const Eigen::Vector3d t = 100 * random.vector();
    const Mesh_view moved = mapped(
        mesh, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(scale * (R * p + t)); });
    EXPECT_NEAR(sweep_operations(moved), reference, 0.1 * reference);
  }
}

}  // namespace cgp_test::sweep_nested_dissection_tests
