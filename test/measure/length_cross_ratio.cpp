// Tests include/Conformal_geometry_processing/measure/distortion.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/moebius.h"

namespace cgp_test::length_cross_ratio_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Log_length_cross_ratios, of_two_triangles_follow_from_their_four_lengths)
{
  // Edge 0-1, left of it vertex 2 at distances 3 and 4, right of it vertex 3 at 5 and 12.
  // l_03 l_12 / (l_31 l_20) with i = 0, j = 1, k = 2, l = 3.
  const Mesh_view mesh(points({{0, 0, 0}, {5, 0, 0}, {1.8, 2.4, 0}, {0, -5, 0}}),
                       {{0, 1, 2}, {1, 0, 3}});
  const double l_03 = 5, l_12 = 4, l_31 = std::sqrt(50.), l_20 = 3;
  const Eigen::VectorXd ratios = CGP::log_length_cross_ratios(mesh, mesh.positions());
  EXPECT_NEAR(ratios[0], std::log(l_03 * l_12 / (l_31 * l_20)), 1e-15);
  for (int k = 1; k < 5; ++k) EXPECT_EQ(ratios[k], 0);
}

TEST(Log_length_cross_ratios, do_not_depend_on_the_direction_of_the_edge)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const std::vector<int> number = random_permutation(42, 3);
  const Mesh_view other = renumbered(mesh, number);
  const Eigen::VectorXd a = CGP::log_length_cross_ratios(mesh, mesh.positions());
  const Eigen::VectorXd b = CGP::log_length_cross_ratios(other, other.positions());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    EXPECT_NEAR(a[mesh.edge(h)], b[other.edge(h)], 1e-14);
}

TEST(Log_length_cross_ratios, add_up_to_zero_around_every_inner_vertex)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Eigen::VectorXd ratio = CGP::log_length_cross_ratios(mesh, mesh.positions());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(42);
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (int v : mesh.ends(k)) sum[v] += ratio[k];
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Length_cross_ratio_change, is_zero_for_moebius_maps_where_the_quasi_conformal_error_is_not)
{
  for (const Mesh_view& mesh : {bumpy_sphere(2), torus(2, 1, 20, 10), disk(5)}) {
    const Points moved = inverted(mesh, {.3, .1, 2.5}).positions();
    EXPECT_LT(CGP::length_cross_ratio_change(mesh, moved).max, 1e-12);
    EXPECT_LT(CGP::length_cross_ratio_change(mesh, moved).rms, 1e-12);
    EXPECT_GT(CGP::quasi_conformal_error(mesh, moved).mean, 1.001);
  }
}

TEST(Length_cross_ratio_change, sees_a_map_that_is_not_conformal)
{
  EXPECT_GT(CGP::length_cross_ratio_change(icosphere(2), bumpy_sphere(2).positions()).rms, 1e-2);
}

TEST(Length_cross_ratio_change, takes_the_mean_over_inner_edges_alone)
{
  // One inner edge of five.
  Points p = unit_square().positions();
  p.col(2) << 2, 1, 0;
  // Diagonal 0-2: l_12 goes from 1 to sqrt(2), l_23 from 1 to 2; k = 3 is on the left.
  const double wanted = std::abs(std::log(2.) - std::log(std::sqrt(2.)));
  const auto change = CGP::length_cross_ratio_change(unit_square(), p);
  EXPECT_NEAR(change.max, wanted, 1e-15);
  EXPECT_NEAR(change.rms, wanted, 1e-15);
}

TEST(Length_cross_ratio_change, of_a_triangle_is_none)
{
  Points p = single_triangle().positions();
  p.row(0) *= 5;
  const auto change = CGP::length_cross_ratio_change(single_triangle(), p);
  EXPECT_EQ(change.rms, 0);
  EXPECT_EQ(change.max, 0);
}

}  // namespace cgp_test::length_cross_ratio_tests
