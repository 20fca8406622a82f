// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Conformal_mesh_traits.h
#include <Conformal_geometry_processing/core/Conformal_mesh_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "core/conformal_mesh_traits_checks.h"
#include "support/cgal_meshes.h"
#include "support/meshes.h"

// Compiled alone: without the header of its specialisation a Surface_mesh is a mesh like any other.
namespace cgp_test::conformal_mesh_traits_tests {

using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

TEST(Conformal_mesh_traits, of_any_mesh_supply_maps_with_initial_values)
{
  expect_a_model_of_conformal_mesh_traits(to_cgal_mesh<Surface>(icosphere(1)));
}

TEST(Conformal_mesh_traits, of_any_mesh_leave_the_mesh_as_it_is)
{
  const Surface mesh = to_cgal_mesh<Surface>(tetrahedron());
  const auto before = mesh.properties<Surface::Vertex_index>();
  const CGP::Conformal_mesh_traits<Surface> traits(mesh);
  EXPECT_EQ(mesh.properties<Surface::Vertex_index>(), before);
}

TEST(Conformal_mesh_traits, made_twice_hold_their_own_values)
{
  const Surface mesh = to_cgal_mesh<Surface>(tetrahedron());
  const CGP::Conformal_mesh_traits<Surface> first(mesh), second(mesh);
  write_numbers(mesh, first, 2);
  write_numbers(mesh, second, 9);
  expect_numbers(mesh, first, 2);
}

}  // namespace cgp_test::conformal_mesh_traits_tests
