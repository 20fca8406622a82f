// Tests include/Conformal_geometry_processing/mesh/mean_edge_length.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/bounded_meshes.h"
#include "support/meshes.h"

namespace cgp_test::mean_edge_length_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Mean_edge_length, counts_inner_edges_once)
{
  EXPECT_DOUBLE_EQ(CGP::mean_edge_length(single_triangle()), (2 + 1 + std::sqrt(5)) / 3);
  EXPECT_DOUBLE_EQ(CGP::mean_edge_length(unit_square()), (4 + std::sqrt(2)) / 5);
}

TEST(Mean_edge_length, of_a_regular_solid_is_that_of_each_edge)
{
  const Mesh_view mesh = scaled(icosahedron(), 3);
  const double edge = (mesh.position(mesh.ends(0)[1]) - mesh.position(mesh.ends(0)[0])).norm();
  EXPECT_NEAR(CGP::mean_edge_length(mesh), edge, 1e-14);
}

}  // namespace cgp_test::mean_edge_length_tests
