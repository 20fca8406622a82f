// Tests include/Conformal_geometry_processing/operators/mass_matrices.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::mass_matrices_tests {

namespace CGP = Conformal_geometry_processing;

/// the area of the points of a triangle that are nearest to corner 0, by counting a fine grid
double nearest_area_by_counting(const Mesh_view& triangle, int n)
{
  const Eigen::Vector3d a = triangle.position(0), b = triangle.position(1),
                        c = triangle.position(2);
  int count = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n - i; ++j)
      for (int half = 0; half < (j < n - i - 1 ? 2 : 1); ++half) {
        const double s = (i + (1. + half) / 3) / n, t = (j + (1. + half) / 3) / n;
        const Eigen::Vector3d p = a + s * (b - a) + t * (c - a);
        count += (p - a).norm() < std::min((p - b).norm(), (p - c).norm());
      }
  return area(triangle) * count / (double(n) * n);
}

TEST(Face_areas, of_known_triangles)
{
  EXPECT_EQ(CGP::face_areas(single_triangle())[0], 1);
  EXPECT_EQ(CGP::face_areas(unit_square()), Eigen::Vector2d(.5, .5));
  for (double a : CGP::face_areas(tetrahedron())) EXPECT_NEAR(a, 2 * std::sqrt(3.), 1e-14);
}

TEST(Vertex_areas, are_a_third_of_the_faces_around)
{
  EXPECT_LT((CGP::vertex_areas(unit_square()) - Eigen::Vector4d(2, 1, 2, 1) / 6).norm(), 1e-15);
  for (double a : CGP::vertex_areas(tetrahedron())) EXPECT_NEAR(a, 2 * std::sqrt(3.), 1e-14);
}

TEST(Voronoi_areas, of_a_right_triangle_halve_its_sides)
{
  // The perpendicular bisectors meet in the middle of the hypotenuse: a rectangle at the corner.
  EXPECT_LT((CGP::voronoi_areas(single_triangle()) - Eigen::Vector3d(.5, .25, .25)).norm(), 1e-15);
}

TEST(Voronoi_areas, of_an_obtuse_triangle_are_a_half_and_two_quarters)
{
  const Mesh_view obtuse(points({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}), {{0, 1, 2}});
  EXPECT_LT((CGP::voronoi_areas(obtuse) - Eigen::Vector3d(.5, .5, 1)).norm(), 1e-15);
}

TEST(Voronoi_areas, count_the_points_that_are_nearest_where_no_angle_is_obtuse)
{
  const Mesh_view acute(points({{0, 0, 0}, {3, 0, 0}, {1, 2, 1}}), {{0, 1, 2}});
  const Eigen::VectorXd areas = CGP::voronoi_areas(acute);
  for (int v = 0; v < 3; ++v) {
    Points p(3, 3);
    p << acute.position(v), acute.position((v + 1) % 3), acute.position((v + 2) % 3);
    EXPECT_NEAR(areas[v], nearest_area_by_counting({p, {{0, 1, 2}}}, 300), 1e-2) << v;
  }
}

TEST(Areas, add_up_to_the_area_of_the_surface)
{
  for (const Mesh_view& mesh :
       {perturbed(icosphere(2), .1), perturbed(disk(4), .1), double_torus()})
    for (const Eigen::VectorXd& areas :
         {CGP::face_areas(mesh), CGP::vertex_areas(mesh), CGP::voronoi_areas(mesh)}) {
      EXPECT_NEAR(areas.sum() / area(mesh), 1, 1e-13);
      EXPECT_GT(areas.minCoeff(), 0);
    }
}

TEST(Areas, grow_with_the_square_of_the_unit)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2), larger = scaled(mesh, 3);
  EXPECT_LT((CGP::face_areas(larger) - 9 * CGP::face_areas(mesh)).norm(), 1e-13);
  EXPECT_LT((CGP::vertex_areas(larger) - 9 * CGP::vertex_areas(mesh)).norm(), 1e-13);
  EXPECT_LT((CGP::voronoi_areas(larger) - 9 * CGP::voronoi_areas(mesh)).norm(), 1e-13);
}

TEST(Areas, grow_with_the_square_of_the_unit_also_beyond_the_roots_of_the_numbers)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  for (const double unit : {1e-150, 1e-80, 1e80, 1e150}) {
    const Mesh_view other = scaled(mesh, unit);
    EXPECT_LT((CGP::face_areas(other) / unit / unit - CGP::face_areas(mesh)).norm(), 1e-13);
    EXPECT_LT((CGP::vertex_areas(other) / unit / unit - CGP::vertex_areas(mesh)).norm(), 1e-13);
    EXPECT_LT((CGP::voronoi_areas(other) / unit / unit - CGP::voronoi_areas(mesh)).norm(), 1e-13);
  }
}

}  // namespace cgp_test::mass_matrices_tests
