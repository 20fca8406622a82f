// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/filter_curvature.h
// Tests include/Conformal_geometry_processing/minimal_surface.h
// Tests include/Conformal_geometry_processing/nearest_spin_transform.h
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include "shape_editing_checks.h"

namespace cgp_test::shape_editing_polyhedron_3_tests {

using Surface = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

TEST(Shape_editing_of_a_Polyhedron_3, is_that_of_its_triangles)
{
  expect_nearest_transformation(to_cgal_mesh<Surface>(icosphere(2)), 1e-12);
  expect_minimal_surface(to_cgal_mesh<Surface>(cap_to_flatten()), 1e-12);
  expect_filtered_curvature(to_cgal_mesh<Surface>(icosphere(2)));
}

}  // namespace cgp_test::shape_editing_polyhedron_3_tests
