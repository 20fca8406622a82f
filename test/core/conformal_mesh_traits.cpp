// Compiled alone: without the header of its specialisation a Surface_mesh is a mesh like any other.
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/core/Conformal_mesh_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "core/conformal_mesh_traits_checks.h"
#include "support/cgal_meshes.h"
#include "support/meshes.h"

#include <memory>
#include <string>
#include <vector>

namespace cgp_test::conformal_mesh_traits_tests {

using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

using namespace Conformal_geometry_processing;
using Map = internal::Associated_property_map<std::string, int>;

auto numbering(const std::vector<std::string>& keys)
{
  return std::make_shared<const internal::Element_numbering<std::string>>(keys);
}

TEST(Element_numbering, counts_from_0_in_the_order_of_the_range)
{
  const internal::Element_numbering<std::string> number(std::vector<std::string>{"c", "a", "b"});
  EXPECT_EQ(number.size(), 3U);
  EXPECT_EQ(number("c"), 0U);
  EXPECT_EQ(number("a"), 1U);
  EXPECT_EQ(number("b"), 2U);
}

TEST(Associated_property_map, has_the_initial_value_everywhere)
{
  const Map map(numbering({"a", "b"}), 7);
  EXPECT_EQ(get(map, "a"), 7);
  EXPECT_EQ(map["b"], 7);
}

TEST(Associated_property_map, gives_what_was_put_and_lets_it_be_changed_in_place)
{
  const Map map(numbering({"a", "b"}), 7);
  put(map, "a", 1);
  get(map, "b") += 1;
  EXPECT_EQ(get(map, "a"), 1);
  EXPECT_EQ(get(map, "b"), 8);
}

TEST(Associated_property_map, shares_its_values_with_its_copies_and_with_no_other_map)
{
  const auto keys = numbering({"a", "b"});
  const Map map(keys, 0), copy = map, other(keys, 0);
  put(copy, "a", 1);
  EXPECT_EQ(get(map, "a"), 1);
  EXPECT_EQ(get(other, "a"), 0);
}

TEST(Associated_property_map, refuses_an_element_that_came_later)
{
  const Map map(numbering({"a", "b"}), 0);
  EXPECT_THROW(get(map, "c"), Precondition_error);
  EXPECT_THROW(put(map, "c", 1), Precondition_error);
}

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
