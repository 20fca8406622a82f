// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Fairing_patch.h
#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <string>

#include "fairing_tools.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"

namespace cgp_test::fairing_patch_tests {

using CGP::internal::Fairing_patch;

std::string complaint(const Mesh_view& mesh, const std::vector<char>& region)
{
  try {
    const Fairing_patch patch(mesh, region, "f");
  } catch (const CGP::Precondition_error& error) {
    return error.message();
  }
  return "";
}

TEST(Fairing_patch, has_the_whole_rings_of_the_vertices_that_bend)
{
  const Mesh_view mesh = grid(10, 10);
  const auto middle = region_where(
      mesh, [](const auto& c) { return std::abs(c.x() - .5) < .2 && std::abs(c.y() - .5) < .2; });
  const Fairing_patch patch(mesh, middle, "f");
  EXPECT_EQ(patch.size(), 9);  // of 4 x 4 squares
  int bending = 0, moving = 0;
  for (int v = 0; v < patch.mesh().size_of_vertices(); ++v) {
    EXPECT_EQ(patch.mesh().position(v), mesh.position(patch.vertices()[at(v)]));
    if (!patch.bends(v)) continue;
    ++bending;
    double angle = 0;
    for (int f = 0; f < patch.mesh().size_of_faces(); ++f)
      for (int c = 0; c < 3; ++c)
        if (patch.mesh().corners(f)[at(c)] == v)
          angle += CGP::corner_angle(patch.mesh().sheet(f), c);
    EXPECT_NEAR(angle, 2 * pi, 1e-12);
  }
  for (int f = 0; f < patch.mesh().size_of_faces(); ++f) moving += patch.moves(f);
  EXPECT_GE(bending, 9 + 12);
  EXPECT_LE(bending, 25);
  EXPECT_GT(moving, 18);
  EXPECT_LE(moving, 32);
}

TEST(Fairing_patch, holds_the_first_row_at_the_boundary)
{
  const Mesh_view mesh = grid(6, 6);
  const Fairing_patch patch(mesh, std::vector<char>(at(mesh.size_of_faces()), 1), "f");
  EXPECT_EQ(patch.size(), 9);  // of 7 x 7 vertices, two rows at each side are held
}

TEST(Fairing_patch, measures_the_angle_of_a_fold)
{
  const auto folded = [](double angle) {
    return mapped(grid(8, 8), [angle](const Eigen::Vector3d& p) {
      const double d = p.x() - .5;
      return d > 0 ? Eigen::Vector3d(.5 + d * std::cos(angle), p.y(), d * std::sin(angle)) : p;
    });
  };
  for (const double angle : {0., .3, 2.}) {
    const Mesh_view mesh = folded(angle);
    const auto half = region_where(grid(8, 8), [](const auto& c) { return c.x() > .5; });
    const Fairing_patch patch(mesh, half, "f");
    const auto jump = CGP::internal::normal_jump(patch, patch.mesh().positions());
    EXPECT_NEAR(jump.max, angle, 1e-12);
    EXPECT_NEAR(jump.rms, angle, 1e-12);  // all held vertices inside of the mesh are on the fold
  }
}

TEST(Fairing_patch, refuses_regions_that_cannot_be_faired)
{
  const Mesh_view sphere = icosphere(1);
  const auto none = [](const auto&) { return false; };
  EXPECT_NE(complaint(sphere, region_where(sphere, none)).find("no vertex of the region can move"),
            std::string::npos);
  const std::vector<char> all(at(sphere.size_of_faces()), 1);
  EXPECT_NE(complaint(sphere, all).find("whole component of vertex 0"), std::string::npos);

  const Mesh_view two = disjoint_union(icosphere(2), sphere, {4, 0, 0});
  const auto region = region_where(two, [](const auto& c) { return c.z() > 0 || c.x() > 2; });
  EXPECT_NE(complaint(two, region).find("whole component of vertex 162"), std::string::npos);
}

TEST(Fairing_patch, refuses_faces_of_area_zero_by_their_number)
{
  Mesh_view mesh = grid(6, 6);
  const std::vector<char> all(at(mesh.size_of_faces()), 1);
  EXPECT_EQ(complaint(mesh, all), "");
  Points p = mesh.positions();
  p.col(24) = p.col(25);
  mesh.set_positions(p);
  const std::string words = complaint(mesh, all);
  EXPECT_NE(words.find("of area zero in or around the region, the first is face "),
            std::string::npos)
      << words;
}

}  // namespace cgp_test::fairing_patch_tests
