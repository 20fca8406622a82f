// Tests include/Conformal_geometry_processing/flow/Class_keeper.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Class_keeper.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include "flow_tools.h"
#include "support/random.h"
#include "support/tori.h"

namespace cgp_test::class_keeper_tests {

using CGP::internal::Class_keeper;

double change(const Mesh_view& mesh, const Points& f)
{
  return CGP::length_cross_ratio_change(mesh, f).max;
}

TEST(Class_keeper, moves_positions_to_the_class_with_area_and_centroid)
{
  for (const Mesh_view& mesh : {bumpy_sphere(3), irregular_torus(2, 1, 24, 12)}) {
    Points f = 3 * perturbed(mesh, .03).positions();
    Class_keeper keeper(mesh);
    EXPECT_TRUE(keeper.snap(f));
    EXPECT_LT(change(mesh, f), 1e-5);
    const Mesh_view snapped(f, mesh.corners());
    EXPECT_NEAR(area(snapped), area(mesh), 1e-10 * area(mesh));
    EXPECT_LT((centroid(snapped) - centroid(mesh)).norm(), 1e-10);
    keeper.polish(f);
    EXPECT_LT(change(mesh, f), 1e-10);
  }
}

TEST(Class_keeper, smooths_within_the_class)
{
  const Mesh_view mesh = radially_perturbed(icosphere(3), .02);
  const double before = CGP::willmore_energy(mesh);
  const auto energy = [&](const Points& f) {
    return CGP::willmore_energy(Mesh_view(f, mesh.corners()));
  };
  const auto f =
      Class_keeper(mesh).smoothed(mesh, [&](const Points& g) { return energy(g) < before; });
  ASSERT_TRUE(f);
  EXPECT_LT(energy(*f), before);
  EXPECT_LT(change(mesh, *f), 1e-5);
}

TEST(Class_keeper, gives_up_where_nothing_is_better)
{
  const Mesh_view mesh = bumpy_sphere(2);
  int trials = 0;
  EXPECT_FALSE(Class_keeper(mesh).smoothed(mesh, [&](const Points&) { return ++trials < 0; }));
  EXPECT_EQ(trials, 3);
}

// Trials that are refused take as long as others: the same one is not made twice in a row, and
// where nothing is better, fewer and fewer steps look for it.
TEST(Class_keeper, tries_the_weakest_smoothing_once)
{
  const Mesh_view mesh = bumpy_sphere(2);
  Class_keeper keeper(mesh);
  const auto trials = [&] {
    int count = 0;
    EXPECT_FALSE(keeper.smoothed(mesh, [&](const Points&) { return ++count < 0; }));
    return count;
  };
  for (const int count : {3, 3, 1, 1}) EXPECT_EQ(trials(), count);
}

TEST(Class_keeper, rests_ever_longer_until_a_smoothing_succeeds)
{
  const Mesh_view mesh = bumpy_sphere(2);
  Class_keeper keeper(mesh);
  const auto rest_after = [&](bool is_better) {
    (void)keeper.smoothed(mesh, [&](const Points&) { return is_better; });
    int steps = 0;
    while (keeper.rests()) ++steps;
    return steps;
  };
  for (const int steps : {0, 1, 2, 4, 8}) EXPECT_EQ(rest_after(false), steps);
  EXPECT_EQ(rest_after(true), 0);
  for (const int steps : {0, 1}) EXPECT_EQ(rest_after(false), steps);
  (void)keeper.smoothed(mesh, [](const Points&) { return false; });
  keeper.wake();
  EXPECT_FALSE(keeper.rests());
}

}  // namespace cgp_test::class_keeper_tests
