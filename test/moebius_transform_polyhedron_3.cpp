// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/moebius_transform.h
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include "moebius_transform_checks.h"

namespace cgp_test::moebius_transform_polyhedron_3_tests {

TEST(Moebius_transform_of_an_exact_Polyhedron_3, moves_each_vertex_by_the_map)
{
  using Surface = CGAL::Polyhedron_3<CGAL::Exact_predicates_exact_constructions_kernel>;
  cgp_test::expect_moebius_transforms(cgp_test::to_cgal_mesh<Surface>(cgp_test::sphere_to_invert()),
                                      1e-13);
}

}  // namespace cgp_test::moebius_transform_polyhedron_3_tests
