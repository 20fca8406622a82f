// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_willmore_flow.h
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include "conformal_willmore_flow_boundary_checks.h"

namespace cgp_test::conformal_willmore_flow_polyhedron_3_tests {

using Surface = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

TEST(Conformal_willmore_flow_of_a_Polyhedron_3, is_that_of_its_triangles)
{
  expect_flow(to_cgal_mesh<Surface>(bumpy_sphere(2)), 1e-14);
}

TEST(Conformal_willmore_flow_of_a_Polyhedron_3, turns_its_boundary)
{
  expect_flow_with_binormals(to_cgal_mesh<Surface>(bumpy_cap_of_few_faces()), 1e-14);
}

}  // namespace cgp_test::conformal_willmore_flow_polyhedron_3_tests
