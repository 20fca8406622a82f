// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Graph_view.h
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include "core/graph_view_checks.h"
#include "support/cgal_meshes.h"

namespace cgp_test::graph_view_linear_cell_complex_tests {

using Traits = CGAL::Linear_cell_complex_traits<3, CGAL::Simple_cartesian<double>>;
using Complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Traits>::type;

TEST(Graph_view_of_a_linear_cell_complex, has_its_triangles)
{
  expect_view_of(icosphere(1), to_cgal_mesh<Complex>(icosphere(1)));
}

TEST(Graph_view_of_a_linear_cell_complex, writes_positions_into_the_mesh)
{
  Complex mesh = to_cgal_mesh<Complex>(icosphere(1));
  expect_positions_are_written(mesh);
}

}  // namespace cgp_test::graph_view_linear_cell_complex_tests
