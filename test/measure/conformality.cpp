// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

#include <cmath>
#include <sstream>

namespace cgp_test::conformality_tests {

namespace CGP = Conformal_geometry_processing;

Points upward(const Mesh_view& mesh)
{
  return Eigen::Vector3d::UnitZ().replicate(1, mesh.size_of_faces());
}

TEST(Conformality, of_a_similarity_is_perfect)
{
  const Mesh_view mesh = grid(4, 3);
  Random random(5);
  const Eigen::Matrix3d R = random.rotation();
  const Points moved = (2.5 * R * mesh.positions()).colwise() + random.vector();
  const CGP::Conformality c = CGP::conformality(mesh, moved, R * upward(mesh));
  EXPECT_NEAR(c.quasi_conformal.mean, 1, 1e-14);
  EXPECT_NEAR(c.quasi_conformal.max, 1, 1e-14);
  EXPECT_NEAR(c.length_cross_ratio.max, 0, 1e-14);
  EXPECT_NEAR(c.scale.min_scale, 2.5, 1e-13);
  EXPECT_NEAR(c.scale.max_scale, 2.5, 1e-13);
  EXPECT_EQ(c.flipped_faces, 0);
}

TEST(Conformality, does_not_depend_on_the_unit)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points moved = mapped(mesh, [](const Eigen::Vector3d& p) {
                         return Eigen::Vector3d(p.x() + .2 * p.y(), 1.3 * p.y(), p.z() + 5);
                       }).positions();
  const CGP::Conformality c =
      CGP::conformality(mesh, moved, CGP::neighbourhood_normals(mesh, moved));
  for (const double unit : {1e-150, 1e-80, 1e80, 1e150}) {
    const Mesh_view other = scaled(mesh, unit);
    const Points moved_there = unit * moved;
    const CGP::Conformality d =
        CGP::conformality(other, moved_there, CGP::neighbourhood_normals(other, moved_there));
    EXPECT_NEAR(d.quasi_conformal.mean, c.quasi_conformal.mean, 1e-12) << unit;
    EXPECT_NEAR(d.quasi_conformal.max, c.quasi_conformal.max, 1e-11) << unit;
    EXPECT_NEAR(d.quasi_conformal_of_new_area, c.quasi_conformal_of_new_area, 1e-12) << unit;
    EXPECT_NEAR(d.scale.min_scale, c.scale.min_scale, 1e-12) << unit;
    EXPECT_NEAR(d.scale.max_scale, c.scale.max_scale, 1e-12) << unit;
    EXPECT_NEAR(d.length_cross_ratio.rms, c.length_cross_ratio.rms, 1e-12) << unit;
    EXPECT_EQ(d.flipped_faces, c.flipped_faces) << unit;
  }
}

TEST(Conformality, of_a_stretch_and_a_reflection_shows_in_every_part)
{
  const Mesh_view mesh = grid(1, 1);
  const Points moved = Eigen::Vector3d(3, -1, 1).asDiagonal() * mesh.positions();
  const CGP::Conformality c = CGP::conformality(mesh, moved, upward(mesh));
  EXPECT_NEAR(c.quasi_conformal.mean, 3, 1e-14);
  EXPECT_NEAR(c.quasi_conformal.p99, 3, 1e-14);
  // The two sides along x grow by 3, those along y by 1: the cross-ratio of the diagonal by 9.
  EXPECT_NEAR(c.length_cross_ratio.max, std::log(9.), 1e-14);
  EXPECT_NEAR(c.scale.max_scale, std::sqrt(3.), 1e-14);
  EXPECT_EQ(c.flipped_faces, 2);
}

TEST(Conformality_io, prints_one_fact_per_line)
{
  Conformal_geometry_processing::Conformality c;
  c.quasi_conformal = {1.015625, 1.03125, 1.0625};
  c.length_cross_ratio = {0.002, 0.005};
  c.scale.min_scale = 0.5;
  c.scale.max_scale = 3;
  c.flipped_faces = 7;
  std::ostringstream out;
  Conformal_geometry_processing::internal::print_conformality(out, c);
  EXPECT_EQ(out.str(),
            "quasi-conformal error  1.01562 mean, 1.03125 for 99 %, 1.0625 at most (1 is "
            "conformal)\n"
            "length cross-ratios    changed by 0.002 rms, 0.005 at most (0 is conformal)\n"
            "lengths                scaled by 0.5 to 3\n"
            "flipped faces          7\n");
}

}  // namespace cgp_test::conformality_tests
