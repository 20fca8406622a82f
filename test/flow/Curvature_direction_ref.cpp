// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests flow/Constrained_direction.h
#include <Conformal_geometry_processing/flow/Constrained_direction.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

#include <vector>

namespace cgp_test::curvature_direction_ref_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Willmore_direction, is_minus_one_over_the_radius_on_spheres)
{
  const CGP::Willmore_direction direction;
  for (const double radius : {0.5, 1., 3.}) {
    const Mesh_view sphere = scaled(icosphere(3), radius);
    EXPECT_LT((radius * direction(sphere).array() + 1).abs().maxCoeff(), 1e-4);
  }
}

TEST(Willmore_direction, is_the_other_way_where_the_surface_is_inside_out)
{
  const CGP::Willmore_direction direction;
  const Mesh_view mesh = bumpy_sphere(2);
  EXPECT_LT((direction(mesh) + direction(with_reversed_faces(mesh))).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Willmore_direction, decreases_the_integral_of_squared_curvature)
{
  const CGP::Willmore_direction direction;
  EXPECT_NEAR(direction.energy(icosphere(4)), 4 * pi, 0.002 * 4 * pi);
  EXPECT_NEAR(direction.energy(torus(std::sqrt(2.), 1, 60, 60)), 2 * pi * pi, 0.01 * 2 * pi * pi);
}

TEST(Willmore_direction, has_no_part_along_the_normals_but_for_the_size_of_faces)
{
  // 2 H N = Delta f, whose integral vanishes: to constrain it is needed where it is filtered only.
  std::vector<double> h, share;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = bumpy_sphere(level);
    const Eigen::VectorXd v = CGP::Willmore_direction()(mesh);
    const Points normals = CGP::vertex_normals(mesh, CGP::internal::Normal_weight::angle);
    const Eigen::VectorXd areas = CGP::voronoi_areas(mesh);
    h.push_back(mean_edge_length(mesh));
    share.push_back((normals * areas.cwiseProduct(v)).norm() / areas.dot(v.cwiseAbs()));
  }
  EXPECT_LT(share.back(), 1e-3);
  EXPECT_GT(slope(h, share), 1.5);
}

struct Only_a_direction {
  Eigen::VectorXd operator()(const Mesh_view&) const { return {}; }
};

TEST(Curvature_direction_ref, has_an_energy_if_the_direction_has)
{
  const CGP::internal::Curvature_direction_ref own, other = Only_a_direction();
  EXPECT_TRUE(own.has_energy());
  EXPECT_FALSE(other.has_energy());
  const Mesh_view mesh = bumpy_sphere(2);
  EXPECT_EQ(other.energy(mesh, mesh), CGP::willmore_energy(mesh));
  EXPECT_EQ(own.energy(mesh, mesh), CGP::willmore_energy(mesh));
}

TEST(Curvature_direction_ref, takes_directions_of_surfaces_in_the_unit_of_the_surface)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const CGP::internal::Curvature_direction_ref own, other = Only_a_direction();
  EXPECT_EQ(own.rate(mesh, mesh, 2), CGP::Willmore_direction()(mesh) / 2);
  EXPECT_EQ(other.rate(mesh, mesh, 2), Only_a_direction()(mesh));
}

}  // namespace cgp_test::curvature_direction_ref_tests
