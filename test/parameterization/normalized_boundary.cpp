// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/parameterization/normalized_boundary.h
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "support/bounded_meshes.h"

namespace cgp_test::normalized_boundary_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Normalized_loops, begin_with_the_longest_one_wherever_it_is)
{
  const Mesh_view outer_first = annulus(.4, 1, 12, 2), outer_last = annulus(1, .4, 12, 2);
  for (const Mesh_view& mesh : {outer_first, with_reversed_faces(outer_last)}) {
    const auto all = CGP::normalized_loops(mesh, CGP::internal::Normalized_boundary::all_loops);
    ASSERT_EQ(all.size(), 2u);
    for (const int v : all[0]) EXPECT_NEAR(mesh.position(v).norm(), 1, 1e-15);
    for (const int v : all[1]) EXPECT_NEAR(mesh.position(v).norm(), .4, 1e-15);
    const auto longest =
        CGP::normalized_loops(mesh, CGP::internal::Normalized_boundary::longest_loop);
    ASSERT_EQ(longest.size(), 1u);
    EXPECT_EQ(longest[0], all[0]);
  }
}

TEST(Lengths_along, end_with_the_circumference)
{
  const Mesh_view mesh = grid(3, 2, 3, 2);
  const auto loop =
      CGP::normalized_loops(mesh, CGP::internal::Normalized_boundary::longest_loop)[0];
  const Eigen::VectorXd length = CGP::lengths_along(mesh, loop);
  ASSERT_EQ(length.size(), 11);
  for (Eigen::Index k = 0; k < 11; ++k) EXPECT_NEAR(length[k], static_cast<double>(k), 1e-14);
}

TEST(Circle_maps, go_round_evenly_in_length_and_are_zero_inside)
{
  const Mesh_view mesh = disk(4);
  const auto loops = CGP::normalized_loops(mesh, CGP::internal::Normalized_boundary::longest_loop);
  const Eigen::MatrixXcd z = CGP::circle_maps(mesh, loops, 3);
  for (std::size_t i = 0; i < loops[0].size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * pi * (k + 1) * static_cast<double>(i) / 24;
      EXPECT_LT(std::abs(z(loops[0][i], k) - std::polar(1., angle)), 1e-13);
    }
  EXPECT_NEAR(z.squaredNorm(), 3 * 24, 1e-12);
}

}  // namespace cgp_test::normalized_boundary_tests
