// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Relaxed_scales.h
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>

#include <gtest/gtest.h>

#include "spin/relaxed_surfaces.h"

namespace cgp_test::relaxed_scales_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Dirac_system;
using CGP::internal::Relaxed_scales;
using On = Curvature_potential::On;

TEST(Relaxed_scales, keeps_to_the_bound)
{
  const Mesh_view mesh = ellipsoid(3);
  for (const On on : {On::vertices, On::faces}) {
    Dirac_system system(mesh);
    CGP::internal::Scale_control control;
    control.bound = 1.5;
    Relaxed_scales scales(system, waves_on(mesh, on, 3), control, {});
    EXPECT_EQ(scales.run(), Relaxed_scales::End::within_bound);
    EXPECT_LE(scales.excess(), 1);
    EXPECT_GE(scales.excess(), .98);
    EXPECT_LE(scales.spins().costs().factorizations, 4);
    EXPECT_LE(scales.spins().costs().solves, 100);
  }
}

}  // namespace cgp_test::relaxed_scales_tests
