// Tests include/Conformal_geometry_processing/mesh/well_shaped_faces.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/well_shaped_faces.h>

#include <gtest/gtest.h>

namespace cgp_test::well_shaped_faces_tests {

namespace CGP = Conformal_geometry_processing;

/// triangles over the edge from (0, 0) to (1, 0), with an apex each
CGP::Mesh_view fan(const Eigen::Matrix2Xd& apexes)
{
  CGP::Points p = CGP::Points::Zero(3, 2 + apexes.cols());
  p(0, 1) = 1;
  p.bottomRightCorner(3, apexes.cols()).topRows(2) = apexes;
  CGP::Mesh_view::Corners corners;
  for (int k = 0; k < apexes.cols(); ++k) corners.push_back({0, 1, 2 + k});
  return {p, corners};
}

TEST(Well_shaped_faces, leave_out_the_thinnest_of_at_most_a_twentieth_of_the_area)
{
  Eigen::Matrix2Xd apexes(2, 6);
  apexes << .5, .5, .5, .01, 0, .3,  //
      1, .051, .03, .02, 0, .049;
  const CGP::Mesh_view mesh = fan(apexes);
  for (const double unit : {1., 1e-30, 1e30}) {
    const CGP::internal::Well_shaped_faces sound =
        CGP::well_shaped_faces({unit * mesh.positions(), mesh.corners()});
    ASSERT_EQ(sound.mesh.size_of_faces(), 3);
    EXPECT_EQ(sound.mesh.corners(0), mesh.corners(0));
    EXPECT_EQ(sound.mesh.corners(1), mesh.corners(1));
    EXPECT_EQ(sound.mesh.corners(2), mesh.corners(5));
    EXPECT_EQ(sound.mesh.size_of_vertices(), mesh.size_of_vertices());
    EXPECT_NEAR(sound.share, 1.1 / 1.15, 1e-12);
  }
}

TEST(Well_shaped_faces, are_all_but_those_without_area_where_all_are_thin)
{
  Eigen::Matrix2Xd apexes(2, 3);
  apexes << .5, 2, .5, .01, 0, .01;
  const CGP::internal::Well_shaped_faces sound = CGP::well_shaped_faces(fan(apexes));
  EXPECT_EQ(sound.mesh.size_of_faces(), 2);
  EXPECT_EQ(sound.share, 1);
}

}  // namespace cgp_test::well_shaped_faces_tests
