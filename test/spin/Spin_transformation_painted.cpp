// Tests include/Conformal_geometry_processing/painting/image_filters.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/painting/image_filters.h>

#include <map>

#include "spin/boundary_tools.h"

namespace cgp_test::spin_transformation_painted_tests {

using CGP::Curvature_band;
using CGP::Gray_image;

/// where the middles of the faces are in a picture of the square [-1, 1]^2
Eigen::Matrix2Xd places(const Mesh_view& mesh)
{
  const Points middles = CGP::means_of_corners(mesh, mesh.positions());
  return (middles.topRows<2>().array() + 1) / 2;
}

/// broad hills, and waves of 24 pixels on them
Gray_image hills_with_waves()
{
  const int size = 128;
  Eigen::ArrayXXd gray(size, size);
  for (int r = 0; r < size; ++r)
    for (int c = 0; c < size; ++c) {
      const double x = 2 * (c + 0.5) / size - 1, y = 1 - 2 * (r + 0.5) / size;
      gray(r, c) = 0.5 + 0.1 * std::sin(3 * x + 1) * std::cos(2 * y) +
                   0.1 * std::sin(16 * pi / 3 * x) * std::sin(16 * pi / 3 * y);
    }
  return Gray_image(gray);
}

/// Q - 1 of a disk that is painted between its fixed tangents
double error_of(const Mesh_view& mesh, const Gray_image& image)
{
  const CGP::Spin_result r = transformed(mesh, Boundary_condition::tangents(),
                                         CGP::painted_curvature(image, places(mesh), 8));
  EXPECT_TRUE(r.report);
  EXPECT_EQ(r.report.conformality.flipped_faces, 0);
  return mean_Q(r) - 1;
}

TEST(Means_of_corners, are_those_of_every_row)
{
  const Mesh_view square = unit_square();
  Eigen::Matrix2Xd uv(2, 4);
  uv << 0, 3, 3, 0, 6, 6, 9, 9;
  Eigen::Matrix2Xd expected(2, 2);
  expected << 2, 1, 7, 8;
  EXPECT_LT((CGP::means_of_corners(square, uv) - expected).norm(), 1e-15);
  EXPECT_LT((CGP::means_of_corners(square, square.positions()).col(0) -
             Eigen::Vector3d(2. / 3, 1. / 3, 0))
                .norm(),
            1e-15);
}

TEST(Painted_curvature, is_zero_for_middle_gray_and_positive_where_it_is_bright)
{
  Eigen::ArrayXXd rows(1, 3);
  rows << 0, 0.5, 1;
  Eigen::Matrix2Xd at(2, 3);
  at << 0, 0.5, 1, 0.5, 0.5, 0.5;
  const Curvature_potential rho = CGP::painted_curvature(Gray_image(rows), at, 8);
  EXPECT_EQ(rho.on, Curvature_potential::On::faces);
  EXPECT_EQ(rho.values, Eigen::Vector3d(-4, 0, 4));
}

TEST(Painted_curvature, bulges_a_disk_where_it_is_bright)
{
  Eigen::ArrayXXd gray = Eigen::ArrayXXd::Constant(32, 32, 0.5);
  gray.block(8, 18, 4, 4) = 1;  // above the middle, and to the right
  const Mesh_view mesh = disk(16);
  const CGP::Spin_result r =
      transformed(mesh, Boundary_condition::tangents(),
                  CGP::painted_curvature(CGP::blurred(Gray_image(gray), 2), places(mesh), 8));
  Eigen::Index top = 0;
  r.positions.row(2).maxCoeff(&top);
  EXPECT_LT((mesh.position(static_cast<int>(top)) - Eigen::Vector3d(0.25, 0.375, 0)).norm(), 0.15);
}

TEST(Painted_curvature, and_its_filters_keep_angles_to_first_order)
{
  const Gray_image image = hills_with_waves();
  const auto pass = [&](Curvature_band band) { return CGP::filtered(image, band, 6); };
  const std::map<std::string, Gray_image> pictures = {{"as it is", image},
                                                      {"low-pass", pass(Curvature_band::low)},
                                                      {"high-pass", pass(Curvature_band::high)},
                                                      {"unsharp", pass(Curvature_band::unsharp)}};
  std::map<std::string, double> fine;
  for (const auto& [name, picture] : pictures) {
    const double coarse = error_of(disk(32), picture);
    fine[name] = error_of(disk(64), picture);
    EXPECT_LT(coarse, 0.0016) << name;
    EXPECT_GT(coarse / fine[name], 1.8) << name;
    EXPECT_LT(coarse / fine[name], 2.2) << name;
  }
  EXPECT_LT(fine["high-pass"], fine["low-pass"]);
  EXPECT_LT(fine["low-pass"], fine["as it is"]);
  EXPECT_LT(fine["as it is"], fine["unsharp"]);
}

}  // namespace cgp_test::spin_transformation_painted_tests
