// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/canonical_metric.h
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include "canonical_metric_checks.h"

namespace cgp_test::canonical_metric_polyhedron_3_tests {

TEST(Canonical_metric_of_a_Polyhedron_3, is_that_of_its_triangles)
{
  using Surface = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  Surface mesh = cgp_test::to_cgal_mesh<Surface>(cgp_test::torus_to_measure());
  cgp_test::expect_canonical_metric(mesh, 1e-12);
}

}  // namespace cgp_test::canonical_metric_polyhedron_3_tests
