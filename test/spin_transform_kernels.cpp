// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin_transform.h
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "spin_transform_checks.h"

namespace cgp_test::spin_transform_kernels_tests {

/// positions and eigenvalue for rho in the number type of the kernel
template <class Kernel>
void expect_transformation_with()
{
  using Surface = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Surface mesh = to_cgal_mesh<Surface>(sphere_to_transform());
  auto rho = get(CGAL::dynamic_vertex_property_t<typename Kernel::FT>(), mesh);
  const Mesh_view before = view_of(mesh);
  fill(vertices(mesh), rho, rho_on_vertices(before).values);
  ASSERT_TRUE(CGP::spin_transform(mesh, rho, unbounded()));
  const CGP::Spin_result expected = expected_result(before, rho_on_vertices(before));
  EXPECT_EQ(view_of(mesh).positions(), expected.positions);
}

TEST(Spin_transform_with_inexact_constructions, is_that_of_the_triangles)
{
  expect_transformation_with<CGAL::Exact_predicates_inexact_constructions_kernel>();
}

TEST(Spin_transform_with_exact_constructions, reads_and_writes_numbers_of_the_kernel)
{
  expect_transformation_with<CGAL::Exact_predicates_exact_constructions_kernel>();
}

}  // namespace cgp_test::spin_transform_kernels_tests
