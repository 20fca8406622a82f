// Tests include/Conformal_geometry_processing/parameterization/pack_in_rows.h
// Tests include/Conformal_geometry_processing/parameterization/place_side_by_side.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/pack_in_rows.h>
#include <Conformal_geometry_processing/parameterization/place_side_by_side.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "support/random.h"
#include "support/several_components.h"

namespace cgp_test::pack_in_rows_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Pack_in_rows, puts_the_highest_one_first_and_begins_rows_where_the_last_one_ends)
{
  Eigen::Matrix2Xd sizes(2, 4);
  sizes << 2, 1, 2, 3, 1, 3, 2, 1;
  // the area with gaps is 20.5, so rows are 4.5 long
  Eigen::Matrix2Xd expected(2, 4);
  expected << 0, 0, 1.5, 2.5, 3.5, 0, 0, 3.5;
  EXPECT_TRUE(CGP::pack_in_rows(sizes, .5).isApprox(expected)) << CGP::pack_in_rows(sizes, .5);
}

TEST(Pack_in_rows, keeps_rectangles_apart)
{
  const double gap = .02;
  Random random(3);
  Eigen::Matrix2Xd sizes(2, 60);
  for (Eigen::Index i = 0; i < sizes.size(); ++i) sizes(i) = .01 + std::abs(random.number());
  sizes(0, 7) = 30;  // longer than the square
  const Eigen::Matrix2Xd low = CGP::pack_in_rows(sizes, gap), high = low + sizes;
  EXPECT_GE(low.minCoeff(), 0);
  for (Eigen::Index i = 0; i < 60; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      EXPECT_TRUE((low.col(i).array() > high.col(j).array() + gap / 2).any() ||
                  (low.col(j).array() > high.col(i).array() + gap / 2).any());
}

TEST(Pack_in_rows, of_nothing_and_of_points_is_well_defined)
{
  EXPECT_EQ(CGP::pack_in_rows(Eigen::Matrix2Xd(2, 0), 1).cols(), 0);
  EXPECT_TRUE(CGP::pack_in_rows(Eigen::Matrix2Xd::Zero(2, 2), 0).isZero());
}

TEST(Place_side_by_side, moves_images_and_nothing_else)
{
  const Joined_meshes all = interleaved({disk(3), disk(4)});
  Eigen::VectorXcd z(all.mesh.size_of_vertices());
  z.real() = all.mesh.positions().row(0).transpose();
  z.imag() = all.mesh.positions().row(1).transpose();
  const Eigen::VectorXcd before = z;
  CGP::place_side_by_side(CGP::connected_components(all.mesh), z);
  for (const auto& vertices : all.vertices) {
    const std::complex<double> move = z[vertices[0]] - before[vertices[0]];
    for (const int v : vertices) EXPECT_LT(std::abs(z[v] - before[v] - move), 1e-15);
  }
  EXPECT_DOUBLE_EQ(z.real().minCoeff(), 0);
  EXPECT_DOUBLE_EQ(z.imag().minCoeff(), 0);
  const Eigen::VectorXcd first = z(all.vertices[0]), second = z(all.vertices[1]);
  EXPECT_GT(first.imag().minCoeff(), second.imag().maxCoeff());  // squares of one size: two rows
}

TEST(Place_side_by_side, has_nothing_to_do_with_nothing)
{
  Eigen::VectorXcd z;
  CGP::place_side_by_side({}, z);
  EXPECT_EQ(z.size(), 0);
}

}  // namespace cgp_test::pack_in_rows_tests
