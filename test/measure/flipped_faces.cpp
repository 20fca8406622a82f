// Tests include/Conformal_geometry_processing/measure/distortion.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::flipped_faces_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Neighbourhood_normals, of_a_flat_surface_point_up)
{
  const Points normals = CGP::neighbourhood_normals(disk(3));
  for (int f = 0; f < normals.cols(); ++f)
    EXPECT_LT((normals.col(f).normalized() - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(Neighbourhood_normals, agree_with_every_face_of_a_smooth_surface)
{
  for (const Mesh_view& mesh : {icosphere(2), bumpy_sphere(3), torus(2, 1, 20, 12)})
    EXPECT_EQ(CGP::flipped_faces(mesh, mesh.positions(), CGP::neighbourhood_normals(mesh)), 0);
}

TEST(Neighbourhood_normals, look_through_a_fold)
{
  // The middle vertex is pulled over the edge of its hexagon: two of six faces are turned over.
  Mesh_view mesh = disk(3);
  Points p = mesh.positions();
  p.col(0) << .4, 0, 0;  // beyond the edges that meet at (1/3, 0)
  mesh.set_positions(p);
  EXPECT_EQ(CGP::flipped_faces(mesh, p, CGP::neighbourhood_normals(mesh)), 2);
}

TEST(Neighbourhood_normals, of_a_deformation_expect_every_fold_to_stay)
{
  Mesh_view folded = disk(3);
  Points p = folded.positions();
  const Points flat = p;
  p.col(0) << .4, 0, 0;
  folded.set_positions(p);
  const auto flips = [&](const Mesh_view& before, const Points& after) {
    return CGP::flipped_faces(before, after, CGP::neighbourhood_normals(before, after));
  };
  const Eigen::Matrix3d R = Random(6).rotation();
  EXPECT_EQ(flips(folded, p), 0);
  EXPECT_EQ(flips(folded, 2 * R * p), 0);
  EXPECT_EQ(flips(folded, flat), 2);
  EXPECT_EQ(flips(disk(3), p), 2);
  EXPECT_EQ(flips(disk(3), flat), 0);
}

TEST(Neighbourhood_normals, of_a_deformation_expect_nothing_where_faces_cancel_out)
{
  const Mesh_view pillow(unit_square().positions().leftCols(3), {{0, 1, 2}, {0, 2, 1}});
  EXPECT_EQ(CGP::neighbourhood_normals(pillow).norm(), 0);
  const Points normals = CGP::neighbourhood_normals(pillow, pillow.positions());
  EXPECT_EQ(CGP::flipped_faces(pillow, pillow.positions(), normals), 0);
}

TEST(Flipped_faces, are_none_under_the_identity_and_all_under_a_reflection)
{
  const Mesh_view mesh = disk(3);
  const Points up = Eigen::Vector3d::UnitZ().replicate(1, mesh.size_of_faces());
  Points reflected = mesh.positions();
  reflected.row(0) *= -1;
  EXPECT_EQ(CGP::flipped_faces(mesh, mesh.positions(), up), 0);
  EXPECT_EQ(CGP::flipped_faces(mesh, reflected, up), mesh.size_of_faces());
}

TEST(Flipped_faces, counts_each_triangle_that_is_turned_over)
{
  Points p = unit_square().positions();
  p.col(3) << 1, 0, 0;  // the second triangle becomes (0,0), (1,1), (1,0)
  const Points up = Eigen::Vector3d::UnitZ().replicate(1, 2);
  EXPECT_EQ(CGP::flipped_faces(unit_square(), p, up), 1);
}

TEST(Flipped_faces, counts_faces_of_area_zero_or_not_a_number)
{
  const Points up = Eigen::Vector3d::UnitZ().replicate(1, 2);
  Points p = unit_square().positions();
  p.col(3) << 2, 2, 0;
  EXPECT_EQ(CGP::flipped_faces(unit_square(), p, up), 1);
  p(0, 3) = std::nan("");
  EXPECT_EQ(CGP::flipped_faces(unit_square(), p, up), 1);
}

TEST(Flipped_faces, does_not_mind_a_rotation_that_is_expected)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::Matrix3d R = Random(6).rotation();
  EXPECT_EQ(CGP::flipped_faces(mesh, R * mesh.positions(), R * CGP::face_normals(mesh)), 0);
}

}  // namespace cgp_test::flipped_faces_tests
