// Tests direct/choose_ordering.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/choose_ordering.h>
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>

#include <gtest/gtest.h>

#include <cmath>

#include "quaternionic_linear_algebra/graphs.h"
#include "quaternionic_linear_algebra/threads/threads.h"
#include "support/spheres.h"

namespace cgp_test::choose_ordering_tests {

double operations(const CGP::Sparse_pattern& pattern, const CGP::internal::Ordering& order)
{
  return CGP::internal::Supernodal_structure(pattern, order).operations();
}

TEST(Choose_ordering, takes_minimum_degree_for_small_meshes)
{
  const Mesh_view mesh = geodesic_sphere(8);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  EXPECT_EQ(operations(pattern, CGP::choose_ordering(pattern, &mesh.positions())),
            operations(pattern, CGP::amd_ordering(pattern)));
}

TEST(Choose_ordering, takes_dissection_where_it_pays)
{
  const Mesh_view mesh = geodesic_sphere(20);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  const double by_dissection =
      operations(pattern, CGP::sweep_nested_dissection(pattern, mesh.positions()));
  const double by_degree = operations(pattern, CGP::amd_ordering(pattern));
  ASSERT_LT(by_dissection, by_degree);
  CGP::internal::Ordering_costs
      costs;  // dissection is expected to cost what 100 factorizations save
  costs.seconds_per_vertex =
      100 * costs.expected_saving * by_degree * costs.seconds_per_operation / pattern.size();
  const auto chosen = [&](int factorizations) {
    return operations(pattern,
                      CGP::choose_ordering(pattern, &mesh.positions(), factorizations, costs));
  };
  EXPECT_EQ(chosen(1), by_degree);
  EXPECT_EQ(chosen(99), by_degree);
  EXPECT_EQ(chosen(101), by_dissection);
}

TEST(Choose_ordering, needs_no_positions)
{
  const Mesh_view mesh = geodesic_sphere(20);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  EXPECT_EQ(operations(pattern, CGP::choose_ordering(pattern, nullptr, 1000000)),
            operations(pattern, CGP::amd_ordering(pattern)));
}

TEST(Choose_ordering, keeps_minimum_degree_where_positions_mislead)
{
  const Mesh_view mesh = geodesic_sphere(16);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  const Eigen::Matrix3Xd nonsense = random_positions(pattern.size(), 3);
  EXPECT_EQ(operations(pattern, CGP::choose_ordering(pattern, &nonsense, 1000000)),
            operations(pattern, CGP::amd_ordering(pattern)));
}

TEST(Choose_ordering, does_not_dissect_limbs)
{
  const Mesh_view mesh = geodesic_sphere(20);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  const double by_dissection =
      operations(pattern, CGP::sweep_nested_dissection(pattern, mesh.positions()));
  const double by_degree = operations(pattern, CGP::amd_ordering(pattern));
  ASSERT_LT(by_dissection, by_degree);
  const auto chosen = [&](double limbs) {
    CGP::internal::Ordering_costs costs;
    costs.limbs = limbs;
    return operations(pattern, CGP::choose_ordering(pattern, &mesh.positions(), 1000000, costs));
  };
  const double size = by_degree / std::pow(pattern.size(), 1.5);
  EXPECT_EQ(chosen(1.01 * size), by_degree);
  EXPECT_EQ(chosen(0.99 * size), by_dissection);
}

// With several threads minimum degree and dissection run at the same time.
TEST(Choose_ordering, is_the_same_for_any_number_of_threads)
{
  const Mesh_view mesh = geodesic_sphere(21);
  const CGP::Sparse_pattern pattern = pattern_of(mesh);
  ASSERT_GT(pattern.size(), 4000);  // enough for threads
  for (const int factorizations : {0, 1000000}) {
    const auto order = [&] {
      return CGP::choose_ordering(pattern, &mesh.positions(), factorizations);
    };
    const CGP::internal::Ordering expected = order();
    for (const int threads : {2, 3, 8}) {
      const Threads setting(threads);
      EXPECT_EQ(order(), expected);
    }
  }
}

TEST(Choose_ordering, permutes_any_graph)
{
  for (const Named_graph& graph : graphs_of_all_kinds()) {
    const Eigen::Matrix3Xd p = random_positions(graph.size, 2);
    const auto order = CGP::choose_ordering(pattern_of(graph.size, graph.edges), &p, 1000000);
    EXPECT_EQ(static_cast<int>(CGP::inverse_permutation(order).size()), graph.size) << graph.name;
  }
}

}  // namespace cgp_test::choose_ordering_tests
