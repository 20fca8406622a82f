// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests measure/overlaps.h
#include <Conformal_geometry_processing/measure/overlaps.h>
#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/mesh_tools.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cgp_test::charts_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::charts_without;
using CGP::internal::overlaps;

int size_of(const std::vector<int>& charts)
{
  return 1 + *std::max_element(charts.begin(), charts.end());
}

/// That charts do not overlap, and are connected
void expect_charts(const std::vector<int>& charts, const Mesh_view& mesh, const Points& flat)
{
  for (const auto& [first, second, area] : overlaps(mesh, flat))
    EXPECT_NE(charts[at(first)], charts[at(second)]);
  for (int chart = 0; chart < size_of(charts); ++chart) {
    std::vector<char> is_in(charts.size());
    std::transform(charts.begin(), charts.end(), is_in.begin(), [=](int c) { return c == chart; });
    const auto part = CGP::internal::selected_faces(mesh, is_in);
    EXPECT_EQ(CGP::topology(part.mesh).components, 1);
  }
}

/// z^power of a ring that is cut, which covers itself where power > 1
Points power_map(const Mesh_view& strip, double power)
{
  return mapped(strip,
                [=](const Eigen::Vector3d& p) {
                  const double a = 2 * pi * p.x() * power, r = std::exp(-p.y() * power);
                  return Eigen::Vector3d(r * std::cos(a), r * std::sin(a), 0);
                })
      .positions();
}

TEST(Charts, are_one_for_each_component_without_overlaps)
{
  const Mesh_view disk = jittered_disk(6, .3), two = disjoint_union(disk, disk, {9, 0, 0});
  EXPECT_EQ(size_of(charts_without({}, disk)), 1);
  EXPECT_EQ(size_of(charts_without({}, two)), 2);
  expect_charts(charts_without({}, two), two, two.positions());
}

// As many as there are turns begun would do; the growth may end within one.
TEST(Charts, are_few_where_an_image_is_wound)
{
  Mesh_view strip = grid(80, 6, 1, .1);
  Eigen::Matrix3Xd moved = strip.positions();
  for (Eigen::Index v = 0; v < moved.cols(); ++v)
    moved(1, v) += .004 * std::sin(37. * static_cast<double>(v)) * (moved(1, v) > .01);
  strip.set_positions(moved);
  for (const double power : {.9, 1.4, 2.6, 4.3}) {
    const Points flat = power_map(strip, power);
    const auto charts = charts_without(overlaps(strip, flat), strip);
    expect_charts(charts, strip, flat);
    EXPECT_GE(size_of(charts), std::ceil(power));
    EXPECT_LE(size_of(charts), 3 * std::ceil(power));
  }
}

}  // namespace cgp_test::charts_tests
