// Tests adapters/Metis_ordering.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Metis_ordering.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_structure.h>
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>

#include <gtest/gtest.h>

#include <cstdlib>

#include "quaternionic_linear_algebra/graphs.h"
#include "support/spheres.h"

namespace cgp_test::metis_ordering_tests {

TEST(Metis_ordering, permutes_the_vertices_of_any_graph)
{
  for (const Named_graph& graph : graphs_of_all_kinds()) {
    const CGP::internal::Ordering order = CGP::metis_ordering(pattern_of(graph.size, graph.edges));
    EXPECT_EQ(static_cast<int>(order.size()), graph.size) << graph.name;
    EXPECT_EQ(CGP::inverse_permutation(order).size(), order.size()) << graph.name;
  }
}

TEST(Metis_ordering, fills_in_less_than_minimum_degree_and_about_as_much_as_the_sweep)
{
  for (int frequency : {20, 41}) {
    const Mesh_view mesh = geodesic_sphere(frequency);
    const CGP::Sparse_pattern pattern = pattern_of(mesh);
    const auto operations = [&](const CGP::internal::Ordering& order) {
      return CGP::internal::Supernodal_structure(pattern, order).operations();
    };
    const double by_metis = operations(CGP::metis_ordering(pattern));
    const double by_sweep = operations(CGP::sweep_nested_dissection(pattern, mesh.positions()));
    EXPECT_LT(by_metis, operations(CGP::amd_ordering(pattern)));
    EXPECT_LT(by_sweep, 1.15 * by_metis);
    EXPECT_LT(by_metis, 1.25 * by_sweep);
  }
}

TEST(Metis_ordering, is_the_same_twice_whatever_has_been_drawn_from_rand)
{
  const CGP::Sparse_pattern pattern = pattern_of(geodesic_sphere(30));
  std::srand(2);
  const CGP::internal::Ordering first = CGP::metis_ordering(pattern);
  std::srand(3);
  std::rand();
  EXPECT_EQ(CGP::metis_ordering(pattern), first);
}

TEST(Metis_ordering, refuses_what_metis_refuses)
{
  EXPECT_NO_THROW(CGP::internal::check_metis_status(METIS_OK));
  EXPECT_THROW(CGP::internal::check_metis_status(METIS_ERROR_INPUT), CGP::Solver_error);
  EXPECT_THROW(CGP::internal::check_metis_status(METIS_ERROR_MEMORY), std::bad_alloc);
}

}  // namespace cgp_test::metis_ordering_tests
