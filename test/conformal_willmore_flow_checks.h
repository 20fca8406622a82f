// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include "support/cgal_meshes.h"
#include "support/meshes.h"
#include "support/views.h"

/// What conformal_willmore_flow() does to a mesh of any type, measured against the class on flat
/// arrays.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

/// Positions and energies equal those of the class, up to the precision of the points
template <class Mesh>
void expect_flow(Mesh mesh, double tolerance)
{
  CGP::Conformal_willmore_flow expected(view_of(mesh));
  const CGP::Flow_report expected_report = expected.run();
  const CGP::Flow_report report = CGP::conformal_willmore_flow(mesh);
  EXPECT_TRUE(report.converged());
  EXPECT_EQ(report.stop, expected_report.stop);
  ASSERT_EQ(report.steps.size(), expected_report.steps.size());
  EXPECT_EQ(report.energy, expected_report.energy);
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.mesh().positions()), tolerance);
}

}  // namespace cgp_test
