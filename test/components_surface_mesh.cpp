// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform.h, conformal_willmore_flow.h
// Tests conformal_parameterization.h, core/Graph_view.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "components_checks.h"

namespace cgp_test::components_surface_mesh_tests {

using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

TEST(Components_of_a_Surface_mesh, spin_as_they_do_alone)
{
  expect_spins_as_alone<Surface>();
}

TEST(Components_of_a_Surface_mesh, flow_as_they_do_alone)
{
  expect_flows_as_alone<Surface>();
}

TEST(Components_of_a_Surface_mesh, are_flattened_as_they_are_alone)
{
  expect_flat_images_as_alone<Surface>();
}

}  // namespace cgp_test::components_surface_mesh_tests
