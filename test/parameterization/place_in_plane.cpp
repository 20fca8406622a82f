// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>

#include <gtest/gtest.h>

#include "flat_maps.h"
#include "support/random.h"
#include "support/several_components.h"

#include <cmath>
#include <complex>

namespace cgp_test::place_in_plane_tests {

namespace CGP = Conformal_geometry_processing;
using Complex = std::complex<double>;

TEST(Place_in_plane, finds_the_same_image_for_all_similar_ones)
{
  const Mesh_view mesh = disk(3);
  const Eigen::VectorXcd z = plane_points(mesh);
  const std::vector<int> loop = {19, 20, 21, 22, 23, 24, 25, 26, 27,
                                 28, 29, 30, 31, 32, 33, 34, 35, 36};
  for (const Complex factor : {Complex(1, 0), Complex(0, 3), Complex(-1e-7, 2e-7)}) {
    const Eigen::VectorXcd moved = (factor * z).array() + 5. * factor;
    EXPECT_LT((CGP::place_in_plane(mesh, moved, loop) - z).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(Place_in_plane, counts_flipped_faces_with_their_areas)
{
  const Mesh_view mesh = unit_square();
  Eigen::VectorXcd folded(4);
  folded << 0, 1, Complex(1, 1), 1.;  // the second face is flat on the first one's edge
  const Eigen::VectorXcd z = CGP::place_in_plane(mesh, folded, {0, 1, 2, 3});
  const double side = std::abs(z[1] - z[0]), height = std::abs(z[2] - z[1]);
  EXPECT_NEAR(side * height / 2 * 2, 1, 1e-14);
}

TEST(Place_in_plane, leaves_a_point_alone)
{
  const Eigen::VectorXcd z =
      CGP::place_in_plane(unit_square(), Eigen::VectorXcd::Constant(4, Complex(2, 3)), {0, 1});
  EXPECT_LT(z.norm(), 1e-15);
}

TEST(In_space, has_height_zero)
{
  Eigen::VectorXcd z(1);
  z << Complex(2, 3);
  EXPECT_EQ(CGP::in_space(z).col(0), Eigen::Vector3d(2, 3, 0));
}

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

}  // namespace cgp_test::place_in_plane_tests
