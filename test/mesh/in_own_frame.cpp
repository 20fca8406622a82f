// Tests include/Conformal_geometry_processing/mesh/in_own_frame.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/in_own_frame.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace cgp_test::in_own_frame_tests {

namespace CGP = Conformal_geometry_processing;

TEST(In_own_frame, is_of_moderate_size_around_the_origin)
{
  const Mesh_view mesh = mapped(perturbed(icosphere(1), .2), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p + Eigen::Vector3d(5, 0, -3));
  });
  const Mesh_view wanted = CGP::internal::in_own_frame(mesh);
  EXPECT_EQ(wanted.corners(), mesh.corners());
  EXPECT_LT(wanted.positions().cwiseAbs().maxCoeff(), 2);
  EXPECT_GT(wanted.positions().cwiseAbs().maxCoeff(), .5);
  for (const int exponent : {-900, 900})
    EXPECT_EQ(CGP::internal::in_own_frame(scaled(mesh, std::ldexp(1., exponent))).positions(),
              wanted.positions());
}

}  // namespace cgp_test::in_own_frame_tests
