// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/gauge.h
#include <Conformal_geometry_processing/spin/gauge.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::restore_area_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Restore_area, takes_a_similar_surface_back_and_its_spins_to_length_one)
{
  const Mesh_view mesh = mapped(bumpy_sphere(2), [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return p + Eigen::Vector3d(2, -1, 3);
  });
  Points f = 9 * mesh.positions();
  f.colwise() += Eigen::Vector3d(1, 5, -7);
  Quaternion_vector<double> lambda =
      Quaternion_vector<double>::Constant(f.cols(), Quaternion<double>{0, 0, 3, 0});
  CGP::restore_area(mesh, f, lambda);
  EXPECT_LT((f - mesh.positions()).cwiseAbs().maxCoeff(), 1e-12);
  for (const Quaternion<double>& q : lambda) EXPECT_NEAR(norm(q), 1, 1e-14);
}

}  // namespace cgp_test::restore_area_tests
