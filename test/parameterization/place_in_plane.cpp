// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/parameterization/place_in_plane.h
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>

#include <gtest/gtest.h>

#include <complex>

#include "flat_maps.h"

namespace cgp_test::place_in_plane_tests {

namespace CGP = Conformal_geometry_processing;
using Complex = std::complex<double>;

TEST(Place_in_plane, finds_the_same_image_for_all_similar_ones)
{
  const Mesh_view mesh = disk(3);
  const Eigen::VectorXcd z = plane_points(mesh);
  const std::vector<int> loop = {19, 20, 21, 22, 23, 24, 25, 26, 27,
                                 28, 29, 30, 31, 32, 33, 34, 35, 36};
  for (const Complex factor : {Complex(1, 0), Complex(0, 3), Complex(-1e-7, 2e-7)}) {
    const Eigen::VectorXcd moved = (factor * z).array() + 5. * factor;
    EXPECT_LT((CGP::place_in_plane(mesh, moved, loop) - z).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(Place_in_plane, counts_flipped_faces_with_their_areas)
{
  const Mesh_view mesh = unit_square();
  Eigen::VectorXcd folded(4);
  folded << 0, 1, Complex(1, 1), 1.;  // the second face is flat on the first one's edge
  const Eigen::VectorXcd z = CGP::place_in_plane(mesh, folded, {0, 1, 2, 3});
  const double side = std::abs(z[1] - z[0]), height = std::abs(z[2] - z[1]);
  EXPECT_NEAR(side * height / 2 * 2, 1, 1e-14);
}

TEST(Place_in_plane, leaves_a_point_alone)
{
  const Eigen::VectorXcd z =
      CGP::place_in_plane(unit_square(), Eigen::VectorXcd::Constant(4, Complex(2, 3)), {0, 1});
  EXPECT_LT(z.norm(), 1e-15);
}

TEST(In_space, has_height_zero)
{
  Eigen::VectorXcd z(1);
  z << Complex(2, 3);
  EXPECT_EQ(CGP::in_space(z).col(0), Eigen::Vector3d(2, 3, 0));
}

}  // namespace cgp_test::place_in_plane_tests
