// Tests include/Conformal_geometry_processing/mesh/normals.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/normals.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::normals_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Normal_weight;

constexpr Normal_weight all_weights[] = {Normal_weight::area, Normal_weight::angle,
                                         Normal_weight::uniform};

double greatest_difference(const Points& a, const Points& b)
{
  return (a - b).colwise().norm().maxCoeff();
}

TEST(Face_normals, of_a_flat_counter_clockwise_face_point_up)
{
  const Points up = Eigen::Vector3d::UnitZ().replicate(1, 2);
  EXPECT_EQ(CGP::face_normals(unit_square()), up);
  EXPECT_EQ(CGP::face_normals(with_reversed_faces(unit_square())), -up);
}

TEST(Face_normals, do_not_under_or_overflow)
{
  for (double size : {1e-150, 1e150})
    EXPECT_LT(greatest_difference(CGP::face_normals(scaled(icosphere(1), size)),
                                  CGP::face_normals(icosphere(1))),
              1e-14);
}

TEST(Corner_angle, of_the_half_square_is_90_45_45_degrees)
{
  const Mesh_view mesh = unit_square();  // corner 1 of face 0 is the right angle
  EXPECT_NEAR(CGP::corner_angle(mesh.sheet(0), 0), pi / 4, 1e-15);
  EXPECT_NEAR(CGP::corner_angle(mesh.sheet(0), 1), pi / 2, 1e-15);
  EXPECT_NEAR(CGP::corner_angle(mesh.sheet(0), 2), pi / 4, 1e-15);
}

TEST(Corner_angle, is_accurate_where_the_face_is_a_sliver)
{
  const double thin = 1e-9;  // tan of both small angles
  const Mesh_view mesh(points({{0, 0, 0}, {2, 0, 0}, {1, thin, 0}}), {{0, 1, 2}});
  EXPECT_NEAR(CGP::corner_angle(mesh.sheet(0), 0) / thin, 1, 1e-14);
  EXPECT_NEAR(CGP::corner_angle(mesh.sheet(0), 1) / thin, 1, 1e-14);
  EXPECT_NEAR(CGP::corner_angle(mesh.sheet(0), 2), pi - 2 * thin, 1e-14);
}

TEST(Corner_angle, adds_up_to_pi_in_every_face)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    EXPECT_NEAR(CGP::corner_angle(mesh.sheet(f), 0) + CGP::corner_angle(mesh.sheet(f), 1) +
                    CGP::corner_angle(mesh.sheet(f), 2),
                pi, 1e-14);
}

TEST(Vertex_normals, of_the_icosahedron_are_its_vertices_with_any_weight)
{
  for (Normal_weight weight : all_weights)
    EXPECT_LT(
        greatest_difference(CGP::vertex_normals(icosphere(0), weight), icosphere(0).positions()),
        1e-15);
}

TEST(Vertex_normals, at_the_corner_of_a_cube_are_diagonal_with_angle_weights)
{
  // However the squares are cut: weights by area or number would see the cuts.
  const Points normals = CGP::vertex_normals(cube(), Normal_weight::angle);
  const Points wanted = (2 * cube().positions().array() - 1).matrix() / std::sqrt(3.);
  EXPECT_LT(greatest_difference(normals, wanted), 1e-15);
}

TEST(Vertex_normals, weigh_by_area_angle_or_number)
{
  // Around the edge 0-1: a face in z = 0 of area 2, angle 90 degrees at vertex 0, and one in
  // y = 0 of area 1/2, angle 45 degrees.
  const Mesh_view mesh(points({{0, 0, 0}, {1, 0, 0}, {0, 4, 0}, {1, 0, -1}}),
                       {{0, 1, 2}, {1, 0, 3}});
  const auto normal_at_0 = [&](Normal_weight weight) -> Eigen::Vector3d {
    return CGP::vertex_normals(mesh, weight).col(0);
  };
  EXPECT_LT((normal_at_0(Normal_weight::area) - Eigen::Vector3d(0, -1, 4) / std::sqrt(17.)).norm(),
            1e-15);
  EXPECT_LT((normal_at_0(Normal_weight::angle) - Eigen::Vector3d(0, -1, 2) / std::sqrt(5.)).norm(),
            1e-15);
  EXPECT_LT(
      (normal_at_0(Normal_weight::uniform) - Eigen::Vector3d(0, -1, 1) / std::sqrt(2.)).norm(),
      1e-15);
}

TEST(Vertex_normals, tend_to_those_of_the_torus_with_second_order)
{
  std::vector<double> h, error;
  for (int n : {12, 24, 48}) {
    const Mesh_view mesh = torus(2, 1, 2 * n, n);
    const Points wanted = mapped(mesh, [](const Eigen::Vector3d& p) {
                            const Eigen::Vector3d axis(p.x(), p.y(), 0);
                            return Eigen::Vector3d(p - 2 * axis.normalized());
                          }).positions();
    h.push_back(1. / n);
    error.push_back(greatest_difference(CGP::vertex_normals(mesh, Normal_weight::angle), wanted));
  }
  EXPECT_GT(slope(h, error), 1.8);
  EXPECT_LT(error.back(), 5e-3);
}

TEST(Vertex_normals, turn_with_the_surface)
{
  const Eigen::Matrix3d R = Random(2).rotation();
  const Mesh_view mesh = bumpy_sphere(2);
  const Mesh_view turned(R * mesh.positions(), mesh.corners());
  for (Normal_weight weight : all_weights)
    EXPECT_LT(greatest_difference(CGP::vertex_normals(turned, weight),
                                  R * CGP::vertex_normals(mesh, weight)),
              1e-13);
}

TEST(Vertex_normals, are_of_unit_length_and_outward_at_any_scale)
{
  for (double size : {1e-150, 1., 1e150})
    for (Normal_weight weight : {Normal_weight::area, Normal_weight::uniform}) {
      const Points normals = CGP::vertex_normals(scaled(icosphere(2), size), weight);
      EXPECT_LT((normals.colwise().norm().array() - 1).abs().maxCoeff(), 1e-14);
      EXPECT_LT(greatest_difference(normals, icosphere(2).positions()), .03);
    }
}

TEST(Vertex_normals, are_zero_where_the_faces_cancel_out)
{
  const Mesh_view pillow(points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {{0, 1, 2}, {0, 2, 1}});
  for (Normal_weight weight : all_weights)
    EXPECT_EQ(CGP::vertex_normals(pillow, weight), Points::Zero(3, 3));
}

}  // namespace cgp_test::normals_tests
