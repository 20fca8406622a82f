// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/mesh/closed_curves.h
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/closed_curves.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"

namespace cgp_test::closed_curves_tests {

namespace CGP = Conformal_geometry_processing;
using Curves = std::vector<std::vector<int>>;

Curves curves(const Mesh_view& mesh, const std::vector<int>& marked)
{
  std::vector<char> is_marked(static_cast<std::size_t>(mesh.size_of_vertices()), 0);
  for (const int v : marked) is_marked[static_cast<std::size_t>(v)] = 1;
  return CGP::internal::closed_curves(mesh, is_marked, "f");
}

TEST(Closed_curves, go_along_edges_from_the_smallest_vertex)
{
  const Mesh_view mesh = disk(4);  // rings of 6, 12, 18 and 24 vertices around vertex 0
  EXPECT_TRUE(curves(mesh, {}).empty());
  EXPECT_EQ(curves(mesh, {0, 1, 2}), (Curves{{0, 1, 2}}));
  std::vector<int> both;
  for (int v = 1; v < 7; ++v) both.push_back(v);
  for (int v = 19; v < 37; ++v) both.push_back(v);
  const Curves found = curves(mesh, both);
  ASSERT_EQ(found.size(), 2);
  EXPECT_EQ(found[0].size(), 6);
  EXPECT_EQ(found[1].size(), 18);
  for (const std::vector<int>& curve : found)
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) EXPECT_EQ(curve[k + 1], curve[k] + 1);
}

TEST(Closed_curves, are_refused_where_they_are_open_or_branch)
{
  const auto refusal = [](const std::vector<int>& marked) -> std::string {
    try {
      (void)curves(disk(3), marked);
    } catch (const CGP::Precondition_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({4}),
            "f: 1 vertex on no closed curve, the first is vertex 4; two neighbours on it are "
            "needed, and no more");
  EXPECT_NE(refusal({1, 2}).find("2 vertices on no closed curve"), std::string::npos);
  EXPECT_NE(refusal({0, 1, 2, 3}).find("2 vertices on no closed curve, the first is vertex 0"),
            std::string::npos);
}

}  // namespace cgp_test::closed_curves_tests
