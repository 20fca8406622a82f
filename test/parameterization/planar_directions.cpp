// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/parameterization/normalized_boundary.h
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/meshes.h"

namespace cgp_test::planar_directions_tests {

namespace CGP = Conformal_geometry_processing;

CGP::Spin_result flattened(const Mesh_view& mesh)
{
  return CGP::spin_to_minimal_surface(
      mesh, {CGP::Boundary_condition::tangents(CGP::planar_directions(mesh))});
}

double height_over_width(const Points& p)
{
  const Eigen::Vector3d extent = p.rowwise().maxCoeff() - p.rowwise().minCoeff();
  return extent.z() / extent.x();
}

TEST(Planar_directions, of_a_flat_surface_are_those_it_has_up_to_one_turn)
{
  for (const Mesh_view& mesh : {grid(5, 3, 2, 1), jittered_disk(4, .3), moved_disk(5)}) {
    const Points directions = CGP::planar_directions(mesh);
    const CGP::internal::Boundary_frames frames = CGP::boundary_frames(mesh);
    for (Eigen::Index k = 0; k < directions.cols(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Eigen::Vector3d d = directions.col(k);
      EXPECT_NEAR(d.dot(directions.col(0)), frames.tangent(i).dot(frames.tangent(0)), 1e-12);
      EXPECT_NEAR(d.cross(directions.col(0)).z(), frames.tangent(i).cross(frames.tangent(0)).z(),
                  1e-12);
    }
  }
}

TEST(Planar_directions, make_a_hemisphere_a_round_disk)
{
  std::vector<double> h, errors;
  for (const int n : {8, 16}) {
    const Mesh_view plane = disk(n);
    const CGP::Spin_result result = flattened(cap_from_disk(plane, pi / 2));
    ASSERT_TRUE(result.report);
    EXPECT_EQ(result.report.conformality.flipped_faces, 0);
    h.push_back(1. / n);
    errors.push_back(CGP::align(result.positions, plane.positions()).rms);
  }
  EXPECT_LT(errors.back(), 3e-4);
  EXPECT_NEAR(slope(h, errors), 2, .3);
}

TEST(Planar_directions, flatten_caps_and_graphs)
{
  const Mesh_view bump = mapped(disk(16), [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {p.x(), p.y(), .4 * p.x() * p.y() + .3 * p.x() * p.x() - .2 * std::pow(p.y(), 3)};
  });
  for (const Mesh_view& mesh : {cap_from_disk(disk(16), 2.), bump}) {
    const CGP::Spin_result result = flattened(mesh);
    ASSERT_TRUE(result.report);
    EXPECT_LT(height_over_width(result.positions), 2e-3);
    EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.06);
    EXPECT_EQ(result.report.conformality.flipped_faces, 0);
  }
}

TEST(Planar_directions, are_those_of_disks_only)
{
  for (const Mesh_view& mesh : {annulus(.4, 1, 12, 2), icosphere(1), without_face(btorus(6), 0)}) {
    try {
      (void)CGP::planar_directions(mesh, "here");
      FAIL();
    } catch (const CGP::Precondition_error& error) {
      EXPECT_STREQ(error.what(),
                   "here: the surface is not a disk (one loop, no handles); a disk is "
                   "needed");
    }
  }
}

}  // namespace cgp_test::planar_directions_tests
