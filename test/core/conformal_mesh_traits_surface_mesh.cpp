// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Conformal_mesh_traits_Surface_mesh.h
#include <Conformal_geometry_processing/core/Conformal_mesh_traits_Surface_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include "core/conformal_mesh_traits_checks.h"
#include "support/cgal_meshes.h"
#include "support/meshes.h"

namespace cgp_test::conformal_mesh_traits_surface_mesh_tests {

using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Traits = CGP::Conformal_mesh_traits<Surface>;
using Vertex = Surface::Vertex_index;

TEST(Conformal_mesh_traits_of_a_Surface_mesh, supply_maps_with_initial_values)
{
  expect_a_model_of_conformal_mesh_traits(to_cgal_mesh<Surface>(icosphere(1)));
}

TEST(Conformal_mesh_traits_of_a_Surface_mesh, share_the_values_of_the_mesh)
{
  Surface mesh = to_cgal_mesh<Surface>(icosphere(1));
  const Traits first(mesh);
  write_numbers(mesh, first, 2);
  const Traits second(mesh);
  expect_numbers(mesh, second, 2);
  write_numbers(mesh, second, 9);
  expect_numbers(mesh, first, 9);
}

TEST(Conformal_mesh_traits_of_a_Surface_mesh, leave_their_values_in_the_mesh_and_its_copies)
{
  Surface mesh = to_cgal_mesh<Surface>(icosphere(1));
  write_numbers(mesh, Traits(mesh), 2);
  expect_numbers(mesh, Traits(mesh), 2);
  Surface copy = mesh;
  expect_numbers(copy, Traits(copy), 2);
  write_numbers(copy, Traits(copy), 9);
  expect_numbers(mesh, Traits(mesh), 2);
}

TEST(Conformal_mesh_traits_of_a_Surface_mesh, take_a_property_of_the_user_under_the_known_name)
{
  Surface mesh = to_cgal_mesh<Surface>(tetrahedron());
  mesh.add_property_map<Vertex, double>("v:rho", 1.5);
  EXPECT_EQ(get(Traits(mesh).vertex_curvature_potential_map(), Vertex(2)), 1.5);
}

TEST(Conformal_mesh_traits_of_a_Surface_mesh, give_initial_values_to_vertices_added_later)
{
  Surface mesh = to_cgal_mesh<Surface>(tetrahedron());
  const Traits traits(mesh);
  const Vertex v = mesh.add_vertex();
  EXPECT_EQ(get(traits.vertex_spin_map(), v), (Spin{1, 0, 0, 0}));
}

TEST(Conformal_mesh_traits_of_a_Surface_mesh, refuse_a_property_of_another_type)
{
  Surface mesh = to_cgal_mesh<Surface>(tetrahedron());
  mesh.add_property_map<Vertex, float>("v:rho", 1.5F);
  const auto before = mesh.properties<Vertex>();
  try {
    Traits traits(mesh);
    FAIL() << "accepted";
  } catch (const CGP::Precondition_error& error) {
    EXPECT_NE(error.message().find("v:rho"), std::string::npos);
  }
  EXPECT_EQ(mesh.properties<Vertex>(), before);
}

}  // namespace cgp_test::conformal_mesh_traits_surface_mesh_tests
