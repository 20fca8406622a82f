// Tests include/Conformal_geometry_processing/flow/Class_keeper.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Class_keeper.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include "flow_tools.h"
#include "support/random.h"
#include "support/tori.h"

namespace {

using namespace cgp_test;
using CGP::internal::Class_keeper;

double change(const Mesh_view& mesh, const Points& f)
{
  return CGP::length_cross_ratio_change(mesh, f).max;
}

}  // namespace

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
