// Tests include/Conformal_geometry_processing/mesh/Mesh_component.h
// Tests include/Conformal_geometry_processing/mesh/Component_failures.h
// Tests include/Conformal_geometry_processing/mesh/Component_reports.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Component_failures.h>
#include <Conformal_geometry_processing/mesh/Component_reports.h>
#include <Conformal_geometry_processing/mesh/Mesh_component.h>

#include <gtest/gtest.h>

#include <new>
#include <string>

#include "support/several_components.h"

namespace {

using namespace cgp_test;
namespace CGP = Conformal_geometry_processing;

}  // namespace

TEST(Mesh_components, are_the_meshes_that_were_joined_in_the_order_of_their_first_vertices)
{
  const std::vector<Mesh_view> parts = surfaces_of_different_types();
  const Joined_meshes all = interleaved(parts);
  const auto components = CGP::mesh_components(all.mesh);
  ASSERT_EQ(components.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ(components[p].vertices, all.vertices[p]);
    EXPECT_EQ(components[p].faces, all.faces[p]);
    EXPECT_EQ(components[p].mesh.positions(), parts[p].positions());
    EXPECT_EQ(components[p].mesh.corners(), parts[p].corners());
  }
}

TEST(Mesh_components, of_a_connected_mesh_are_the_mesh)
{
  const Mesh_view mesh = icosahedron();
  const auto components = CGP::mesh_components(mesh);
  ASSERT_EQ(components.size(), 1u);
  EXPECT_EQ(components[0].mesh.corners(), mesh.corners());
}

TEST(Mesh_components, of_nothing_are_none_and_of_a_lonely_vertex_one)
{
  EXPECT_TRUE(CGP::mesh_components(Mesh_view(Points(3, 0), {})).empty());
  const auto components = CGP::mesh_components({Points::Zero(3, 4), {{0, 1, 3}}});
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[1].vertices, std::vector<int>{2});
  EXPECT_EQ(components[1].mesh.size_of_faces(), 0);
}

TEST(Component_failures, names_all_that_failed)
{
  CGP::Component_failures failures(4, "some_function");
  failures.attempt(0, 0, [] {});
  failures.attempt(1, 7, [] { throw CGP::Solver_error("inner", "no factor"); });
  failures.attempt(3, 9, [] { throw CGP::Precondition_error("inner", "it is closed"); });
  try {
    failures.throw_if_any();
    FAIL();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(error.function(), "some_function");
    EXPECT_EQ(error.message(),
              "2 of 4 components failed (their elements are counted in each): component 1, from "
              "vertex 7: no factor; component 3, from vertex 9: it is closed");
  }
}

TEST(Component_failures, are_none_if_nothing_was_thrown)
{
  CGP::Component_failures failures(1, "some_function");
  failures.attempt(0, 0, [] {});
  EXPECT_NO_THROW(failures.throw_if_any());
}

TEST(Component_failures, of_the_solver_alone_are_an_error_of_the_solver)
{
  CGP::Component_failures failures(2, "some_function");
  failures.attempt(1, 7, [] { throw CGP::Solver_error("inner", "no factor"); });
  EXPECT_THROW(failures.throw_if_any(), CGP::Solver_error);
}

TEST(Component_failures, let_what_is_not_of_the_library_pass)
{
  CGP::Component_failures failures(2, "some_function");
  EXPECT_THROW(failures.attempt(1, 7, [] { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(Component_reports, are_true_if_all_of_them_are)
{
  CGP::Component_reports<bool> reports;
  EXPECT_TRUE(reports);
  reports.components.push_back({0, 4, 4, true});
  EXPECT_TRUE(reports);
  reports.components.push_back({4, 4, 4, false});
  EXPECT_FALSE(reports);
}
