// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform.h, dirac_spectrum.h, dirac_sphere.h
#include <Conformal_geometry_processing/core/Conformal_mesh_traits_Polyhedron_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "dirac_spectrum_checks.h"
#include "spin_transform_boundary_checks.h"

namespace cgp_test::spin_transform_polyhedron_3_tests {

using Surface = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

TEST(Spin_transform_of_a_Polyhedron_3, is_that_of_its_triangles)
{
  expect_transformation(to_cgal_mesh<Surface>(sphere_to_transform()), 1e-14);
}

TEST(Spin_transform_of_a_Polyhedron_3, prescribes_what_becomes_of_the_boundary)
{
  expect_transformation_with_boundary(to_cgal_mesh<Surface>(cap_to_transform()), 1e-14);
}

TEST(Spin_transform_of_a_Polyhedron_3, reads_and_fills_the_maps_of_the_mesh_traits)
{
  Surface mesh = to_cgal_mesh<Surface>(sphere_to_transform());
  const Mesh_view before = view_of(mesh);
  const CGP::Conformal_mesh_traits<Surface> traits(mesh);
  fill(vertices(mesh), traits.vertex_curvature_potential_map(), rho_on_vertices(before).values);
  ASSERT_TRUE(CGP::spin_transform(mesh, traits.vertex_curvature_potential_map(),
                                  unbounded().vertex_spin_map(traits.vertex_spin_map())));
  const CGP::Spin_result expected = expected_result(before, rho_on_vertices(before));
  EXPECT_EQ(spins(vertices(mesh), traits.vertex_spin_map(), before.size_of_vertices()),
            expected.lambda);
}

TEST(Dirac_spectrum_of_a_Polyhedron_3, is_that_of_its_triangles)
{
  expect_spectrum_of_the_view(to_cgal_mesh<Surface>(bumpy_sphere(2)));
}

TEST(Dirac_sphere_of_a_Polyhedron_3, is_that_of_its_triangles)
{
  expect_dirac_sphere(to_cgal_mesh<Surface>(icosphere(3)), 1e-9);
}

}  // namespace cgp_test::spin_transform_polyhedron_3_tests
