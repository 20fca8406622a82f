// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_parameterization.h
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include "conformal_parameterization_checks.h"

namespace cgp_test::conformal_parameterization_polyhedron_3_tests {

using Surface = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

TEST(Conformal_parameterization_of_a_Polyhedron_3, is_that_of_its_triangles)
{
  expect_parameterization_of_the_view(to_cgal_mesh<Surface>(cap_to_map()), 1e-12);
}

}  // namespace cgp_test::conformal_parameterization_polyhedron_3_tests
