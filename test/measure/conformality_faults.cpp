// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/measure/Conformality.h
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <gtest/gtest.h>

#include <limits>

#include "support/meshes.h"

namespace cgp_test::conformality_faults_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Conformality;
using Fault = Conformality::Fault;

Conformality measured(const Mesh_view& mesh, const CGP::Points& positions)
{
  Mesh_view moved = mesh;
  moved.set_positions(positions);
  return CGP::conformality(mesh, positions, CGP::face_normals(moved));
}

/// two squares of unit area side by side, as four triangles
Mesh_view two_squares()
{
  CGP::Points points(3, 6);
  points << 0, 1, 2, 0, 1, 2, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0;
  return {points, {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
}

Fault fault_of(const Conformality& map)
{
  return map.fault(Conformality::Limits());
}

TEST(Conformality_faults, of_similarities_has_no_fault)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.1);
  for (const double scale : {1e-6, 1., 1e6}) {
    const Conformality map = measured(mesh, scale * mesh.positions());
    EXPECT_EQ(fault_of(map), Fault::none);
    EXPECT_NEAR(map.quasi_conformal.mean, 1, 1e-9);
    EXPECT_NEAR(map.quasi_conformal_of_new_area, 1, 1e-9);
    EXPECT_EQ(map.scale.collapsed_share, 0);
    EXPECT_EQ(map.flipped_share, 0);
  }
}

// One square becomes a long strip: of the old area half is stretched, of the new nearly all.
TEST(Conformality_faults, is_weighted_by_the_old_and_by_the_new_area)
{
  const Mesh_view mesh = two_squares();
  CGP::Points moved = mesh.positions();
  const double length = 9;
  moved(0, 2) = moved(0, 5) = 1 + length;
  const Conformality map = measured(mesh, moved);
  EXPECT_NEAR(map.quasi_conformal.mean, (1 + length) / 2, 1e-12);
  EXPECT_NEAR(map.quasi_conformal_of_new_area, (1 + length * length) / (1 + length), 1e-12);
}

TEST(Conformality_faults, has_a_fault_where_bad_faces_have_become_most_of_the_surface)
{
  Conformality map;
  map.quasi_conformal.mean = 1.01;
  map.quasi_conformal_of_new_area = 3;
  EXPECT_EQ(fault_of(map), Fault::not_conformal);
}

TEST(Conformality_faults, has_a_fault_where_most_of_the_surface_has_collapsed)
{
  const Mesh_view sphere = icosphere(4);
  for (const double distance :
       {1.01, 2.}) {  // of the centre of an inversion from that of the sphere
    CGP::Points moved = sphere.positions();
    for (Eigen::Index v = 0; v < moved.cols(); ++v) {
      const Eigen::Vector3d p = sphere.positions().col(v) - Eigen::Vector3d(0, 0, distance);
      moved.col(v) = p / p.squaredNorm();
    }
    const Conformality map = measured(sphere, moved);
    EXPECT_EQ(map.scale.collapsed_share > 0.5, distance < 1.1);
    EXPECT_EQ(fault_of(map) == Fault::none, distance > 1.1);
  }
}

TEST(Conformality_faults, has_a_fault_where_faces_are_flipped)
{
  const Mesh_view mesh = icosphere(1);
  const CGP::Points inward = -CGP::face_normals(mesh);
  const Conformality map = CGP::conformality(mesh, mesh.positions(), inward);
  EXPECT_EQ(map.flipped_share, 1);
  EXPECT_EQ(fault_of(map), Fault::flipped);
}

TEST(Conformality_faults, has_a_fault_where_a_number_is_not_finite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Conformality map;
  map.quasi_conformal.mean = nan;
  EXPECT_EQ(fault_of(map), Fault::not_conformal);
  map = {};
  map.quasi_conformal_of_new_area = nan;
  EXPECT_EQ(fault_of(map), Fault::not_conformal);
  map = {};
  map.scale.collapsed_share = nan;
  EXPECT_EQ(fault_of(map), Fault::collapsed);
}

}  // namespace cgp_test::conformality_faults_tests
