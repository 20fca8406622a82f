// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Relaxed_scales.h
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>

#include <gtest/gtest.h>

#include <cmath>

#include "spin/boundary_tools.h"
#include "support/meshes.h"

namespace cgp_test::relaxed_scales_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Dirac_system;
using CGP::internal::Relaxed_scales;
using On = Curvature_potential::On;

Mesh_view ellipsoid(int level)
{
  const auto stretched = [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), 2 * p.y(), p.z());
  };
  return perturbed(mapped(icosphere(level), stretched), .02);
}

Curvature_potential waves(const Mesh_view& mesh, On on, double amplitude)
{
  const auto at_point = [=](const Eigen::Vector3d& p) {
    return amplitude * std::sin(2 * p.y() + 1) * std::cos(3 * p.x());
  };
  return on == On::vertices ? potential_on_vertices(mesh, at_point)
                            : potential_on_faces(mesh, at_point);
}

TEST(Relaxed_scales, keeps_to_the_bound)
{
  const Mesh_view mesh = ellipsoid(3);
  for (const On on : {On::vertices, On::faces}) {
    Dirac_system system(mesh);
    CGP::internal::Scale_control control;
    control.bound = 1.5;
    Relaxed_scales scales(system, waves(mesh, on, 3), control, {});
    EXPECT_EQ(scales.run(), Relaxed_scales::End::within_bound);
    EXPECT_LE(scales.excess(), 1);
    EXPECT_GE(scales.excess(), .98);
    EXPECT_LE(scales.spins().costs().factorizations, 4);
    EXPECT_LE(scales.spins().costs().solves, 100);
  }
}

}  // namespace cgp_test::relaxed_scales_tests
