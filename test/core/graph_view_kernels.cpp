// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Graph_view.h
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "core/graph_view_checks.h"
#include "support/cgal_meshes.h"

namespace cgp_test::graph_view_kernels_tests {

template <class Kernel>
class Graph_view_with_kernel : public testing::Test {};

using Kernels = testing::Types<CGAL::Simple_cartesian<float>,
                               CGAL::Exact_predicates_inexact_constructions_kernel,
                               CGAL::Exact_predicates_exact_constructions_kernel>;
TYPED_TEST_SUITE(Graph_view_with_kernel, Kernels, );

TYPED_TEST(Graph_view_with_kernel, reads_and_writes_coordinates)
{
  using Surface = CGAL::Surface_mesh<typename TypeParam::Point_3>;
  Surface mesh = to_cgal_mesh<Surface>(cube());
  expect_view_of(cube(), mesh);
  expect_positions_are_written(mesh);
}

}  // namespace cgp_test::graph_view_kernels_tests
