// Tests include/Conformal_geometry_processing/measure/distortion.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/meshes.h"

namespace cgp_test::area_distortion_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Length_scales, are_the_factor_of_a_similarity)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Points similar =
      (3 * Random(1).rotation() * mesh.positions()).colwise() + Eigen::Vector3d(1, 2, 3);
  const Eigen::VectorXd scale = CGP::length_scales(mesh, similar);
  EXPECT_LT((scale.array() - 3).abs().maxCoeff(), 1e-13);
}

TEST(Length_scales, are_roots_of_the_quotient_of_areas)
{
  Points p = unit_square().positions();
  p.row(0) *= 2;
  p.row(1) *= 8;
  EXPECT_EQ(CGP::length_scales(unit_square(), p), Eigen::Vector2d(4, 4));
}

TEST(Area_distortion, of_a_similarity_has_no_deviation)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const CGP::internal::Area_distortion d = CGP::area_distortion(mesh, 3 * mesh.positions());
  EXPECT_NEAR(d.min_scale, 3, 1e-14);
  EXPECT_NEAR(d.max_scale, 3, 1e-14);
  EXPECT_NEAR(d.log_deviation, 0, 1e-7);
}

TEST(Area_distortion, weighs_the_deviation_by_area)
{
  // Faces of areas 1 and 3 on both sides of the edge 0-1; the second grows by the factor e^2 in
  // area, so logs of length are 0 and 1 with weights 1/4 and 3/4: the variance is 3/16.
  const Mesh_view mesh(points({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, -3, 0}}),
                       {{0, 1, 2}, {0, 3, 1}});
  Points p = mesh.positions();
  p(1, 3) *= std::exp(2.);
  const CGP::internal::Area_distortion d = CGP::area_distortion(mesh, p);
  EXPECT_NEAR(d.min_scale, 1, 1e-15);
  EXPECT_NEAR(d.max_scale, std::exp(1.), 1e-14);
  EXPECT_NEAR(d.log_deviation, std::sqrt(3. / 16), 1e-14);
}

/// squares of unit area side by side, each scaled about its centre
std::pair<Mesh_view, Points> scaled_squares(int count, double first, double others)
{
  Points before(3, 4 * count), after(3, 4 * count);
  Corners corners;
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d corner(i == 1 || i == 2, i > 1, 0), place(100 * k, 0, 0);
      before.col(4 * k + i) = place + corner;
      after.col(4 * k + i) = place + (k == 0 ? first : others) * corner;
    }
    corners.push_back({4 * k, 4 * k + 1, 4 * k + 2});
    corners.push_back({4 * k, 4 * k + 2, 4 * k + 3});
  }
  return {Mesh_view(before, corners), after};
}

double collapsed_share(const std::pair<Mesh_view, Points>& map)
{
  return CGP::area_distortion(map.first, map.second).collapsed_share;
}

TEST(Area_distortion, tells_what_has_collapsed_beside_the_rest)
{
  EXPECT_EQ(collapsed_share(scaled_squares(4, 1, 1)), 0);
  EXPECT_NEAR(collapsed_share(scaled_squares(4, .01, 1)), .25, 1e-12);
}

// Eighteen of 22,704 faces with nine tenths of the new area: all others shrink to a third only.
TEST(Area_distortion, tells_where_few_faces_have_become_most_of_the_surface)
{
  EXPECT_NEAR(collapsed_share(scaled_squares(1261, std::sqrt(9 * 1260), 1)), .9, 1e-12);
}

TEST(Area_distortion, has_the_same_collapsed_share_for_the_inverse_map)
{
  for (const double scale : {.01, 3., 30., 100.}) {
    const auto map = scaled_squares(40, scale, 1);
    Mesh_view after = map.first;
    after.set_positions(map.second);
    EXPECT_NEAR(collapsed_share(map), collapsed_share({after, map.first.positions()}), 1e-12)
        << scale;
  }
}

TEST(Area_distortion, of_the_identity_is_none)
{
  const CGP::internal::Area_distortion d = CGP::area_distortion(disk(3), disk(3).positions());
  EXPECT_EQ(d.min_scale, 1);
  EXPECT_EQ(d.max_scale, 1);
  EXPECT_EQ(d.log_deviation, 0);
}

// One square of area one becomes larger by factors of two, the others stay: relative to the root
// mean square, which is nearly one, it is in another half octave.
TEST(Area_distortion, counts_the_area_in_half_octaves)
{
  for (const double octaves : {-9., -2.25, 1.25, 9.}) {
    const auto [mesh, positions] = scaled_squares(1000, std::exp2(octaves), 1);
    const CGP::internal::Area_distortion d = CGP::area_distortion(mesh, positions);
    const double usual = std::sqrt((999 + std::exp2(2 * octaves)) / 1000);
    const int bins = static_cast<int>(d.histogram.size());
    const auto bin = [&](double scale) {
      return std::clamp(bins / 2 + static_cast<int>(std::floor(2 * std::log2(scale))), 0, bins - 1);
    };
    EXPECT_NEAR(d.histogram.sum(), 1, 1e-12);
    EXPECT_NEAR(d.histogram[bin(std::exp2(octaves) / usual)], .001, 1e-12) << octaves;
    EXPECT_NEAR(d.histogram[bin(1 / usual)], .999, 1e-12) << octaves;
  }
}

}  // namespace cgp_test::area_distortion_tests
