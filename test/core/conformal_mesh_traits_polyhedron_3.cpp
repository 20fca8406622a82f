// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Conformal_mesh_traits_Polyhedron_3.h
#include <Conformal_geometry_processing/core/Conformal_mesh_traits_Polyhedron_3.h>

#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>

#include "core/conformal_mesh_traits_checks.h"
#include "support/cgal_meshes.h"
#include "support/meshes.h"

namespace cgp_test::conformal_mesh_traits_polyhedron_3_tests {

using Kernel = CGAL::Simple_cartesian<double>;

template <class Polyhedron>
class Conformal_mesh_traits_of_a_polyhedron : public testing::Test {};

using Polyhedra = testing::Types<CGAL::Polyhedron_3<Kernel>,
                                 CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>;
TYPED_TEST_SUITE(Conformal_mesh_traits_of_a_polyhedron, Polyhedra, );

TYPED_TEST(Conformal_mesh_traits_of_a_polyhedron, supply_maps_with_initial_values)
{
  auto mesh = to_cgal_mesh<TypeParam>(icosphere(1));
  expect_initial_values(mesh);
  expect_shared_values(mesh);
  expect_maps_to_outlive_the_traits(mesh);
}

TYPED_TEST(Conformal_mesh_traits_of_a_polyhedron, made_twice_hold_their_own_values)
{
  const auto mesh = to_cgal_mesh<TypeParam>(tetrahedron());
  const CGP::Conformal_mesh_traits<TypeParam> first(mesh), second(mesh);
  write_numbers(mesh, first, 2);
  write_numbers(mesh, second, 9);
  expect_numbers(mesh, first, 2);
}

TYPED_TEST(Conformal_mesh_traits_of_a_polyhedron, survive_a_change_of_other_elements)
{
  auto mesh = to_cgal_mesh<TypeParam>(disjoint_union(tetrahedron(), cube(), {5, 0, 0}));
  const CGP::Conformal_mesh_traits<TypeParam> traits(mesh);
  const auto rho = traits.vertex_curvature_potential_map();
  const auto last = *std::prev(vertices(mesh).end());
  put(rho, last, 4.);
  mesh.erase_connected_component((*vertices(mesh).begin())->halfedge());
  EXPECT_EQ(get(rho, last), 4.);
}

}  // namespace cgp_test::conformal_mesh_traits_polyhedron_3_tests
