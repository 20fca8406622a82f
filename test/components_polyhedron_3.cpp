// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform.h, conformal_willmore_flow.h
// Tests conformal_parameterization.h, core/Graph_view.h
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include "components_checks.h"

namespace cgp_test::components_polyhedron_3_tests {

using Surface = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

TEST(Components_of_a_Polyhedron_3, spin_as_they_do_alone)
{
  expect_spins_as_alone<Surface>();
}

TEST(Components_of_a_Polyhedron_3, flow_as_they_do_alone)
{
  expect_flows_as_alone<Surface>();
}

TEST(Components_of_a_Polyhedron_3, are_flattened_as_they_are_alone)
{
  expect_flat_images_as_alone<Surface>();
}

}  // namespace cgp_test::components_polyhedron_3_tests
