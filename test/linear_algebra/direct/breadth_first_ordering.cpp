// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/linear_algebra/direct/breadth_first_ordering.h
#include <Conformal_geometry_processing/linear_algebra/direct/breadth_first_ordering.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "linear_algebra/graphs.h"
#include "support/spheres.h"

namespace cgp_test::breadth_first_ordering_tests {

TEST(Breadth_first_ordering, permutes_the_vertices_of_any_graph)
{
  for (const Named_graph& graph : graphs_of_all_kinds()) {
    const CGP::internal::Ordering order =
        CGP::breadth_first_ordering(pattern_of(graph.size, graph.edges));
    EXPECT_EQ(static_cast<int>(order.size()), graph.size) << graph.name;
    EXPECT_EQ(CGP::inverse_permutation(order).size(), order.size()) << graph.name;
  }
}

TEST(Breadth_first_ordering, walks_along_a_path_from_its_end)
{
  EXPECT_EQ(CGP::breadth_first_ordering(pattern_of(5, {{2, 0}, {0, 4}, {4, 1}, {1, 3}})),
            (CGP::internal::Ordering{3, 1, 4, 0, 2}));
}

TEST(Breadth_first_ordering, visits_one_component_after_the_other)
{
  EXPECT_EQ(CGP::breadth_first_ordering(pattern_of(5, {{0, 3}, {1, 4}})),
            (CGP::internal::Ordering{3, 0, 4, 1, 2}));
}

TEST(Breadth_first_ordering, keeps_neighbours_near_whatever_the_numbers_of_the_mesh)
{
  const Mesh_view sphere = geodesic_sphere(20);
  const Mesh_view mesh = renumbered(sphere, random_permutation(sphere.size_of_vertices(), 1));
  const std::vector<int> place =
      CGP::inverse_permutation(CGP::breadth_first_ordering(pattern_of(mesh)));
  int farthest = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    farthest =
        std::max(farthest, std::abs(place[at(mesh.ends(k)[0])] - place[at(mesh.ends(k)[1])]));
  // Two zigzag rings around the sphere, of at most about 5 * 20 vertices.
  EXPECT_LT(farthest, 2 * 2 * 100);
}

}  // namespace cgp_test::breadth_first_ordering_tests
