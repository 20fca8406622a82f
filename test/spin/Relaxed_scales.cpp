// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Relaxed_scales.h
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "spin/relaxed_surfaces.h"

namespace cgp_test::relaxed_scales_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Dirac_system;
using CGP::internal::Relaxed_scales;
using CGP::internal::Scale_control;
using End = Relaxed_scales::End;

TEST(Relaxed_scales, keeps_to_the_bound)
{
  const Mesh_view mesh = ellipsoid(3);
  Dirac_system system(mesh);
  const Scale_control control{1.5, {}, {}};
  Relaxed_scales scales(system, waves_on(mesh, 3), control);
  EXPECT_EQ(scales.run(), End::within_bound);
  EXPECT_LE(scales.excess(), 1);
  EXPECT_GE(scales.excess(), .98);
  EXPECT_LE(scales.spins().costs().factorizations, 5);
  EXPECT_LE(scales.spins().costs().solves, 100);
}

// Where the bound is slack it has no effect, and as rho grows, lengths reach it without a jump.
TEST(Relaxed_scales, comes_up_to_the_bound_without_a_jump)
{
  const Mesh_view mesh = ellipsoid(3);
  const Scale_control control{1.5, {}, {}}, none;
  double last = 0;
  for (const double amplitude : {.2, .4, .6, .8, 1., 1.2, 1.4}) {
    Dirac_system system(mesh);
    Relaxed_scales bounded(system, waves_on(mesh, amplitude), control);
    bounded.run();
    EXPECT_GE(bounded.excess(), last - .015) << amplitude;
    EXPECT_LE(bounded.excess(), 1) << amplitude;
    last = bounded.excess();
    if (amplitude > .4) continue;
    Relaxed_scales free(system, waves_on(mesh, amplitude), none);
    EXPECT_EQ(free.run(), End::settled);
    EXPECT_NEAR(system.overlap(free.spins().lambda(), bounded.spins().lambda()), 1, 1e-5);
  }
  EXPECT_GT(last, .98);
}

TEST(Relaxed_scales, is_cancelled_between_steps)
{
  const Mesh_view mesh = ellipsoid(2);
  Dirac_system system(mesh);
  const Scale_control control{1.5, {}, {}};
  Relaxed_scales scales(system, waves_on(mesh, 3), control);
  int asked = 0;
  EXPECT_EQ(scales.run([&](const CGP::Eigensolver_progress&) { return ++asked < 2; }),
            End::cancelled);
  EXPECT_EQ(asked, 2);
  EXPECT_TRUE(scales.solution().cancelled);
}

/// the mean quasi-conformal error of the result, less 1
double mean_distortion(int level)
{
  const Mesh_view mesh = mapped(icosphere(level), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), 2 * p.y(), p.z());
  });
  CGP::Spin_transformation_options options;
  options.scales.bound = 1.5;
  CGP::Spin_transformation transformation(mesh, options);
  const auto result = transformation.transform(Curvature_potential::on_vertices(waves_on(mesh, 2)));
  EXPECT_GT(result.report.scales.excess(), .98);
  return result.report.conformality.quasi_conformal.mean - 1;
}

// The bound is active, and what it asks for goes into rho', not into shear.
TEST(Relaxed_scales, leaves_a_distortion_that_falls_with_the_edge_length)
{
  double last = mean_distortion(2);
  for (const int level : {3, 4, 5}) {
    const double next = mean_distortion(level);
    EXPECT_GT(std::log2(last / next), .9) << level;
    last = next;
  }
}

}  // namespace cgp_test::relaxed_scales_tests
