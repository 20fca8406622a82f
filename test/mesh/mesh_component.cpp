// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <string>
#include <vector>

#include "support/several_components.h"

namespace cgp_test::mesh_component_tests {

namespace CGP = Conformal_geometry_processing;

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

TEST(Failure_reasons, are_told_once_with_the_first_that_have_them)
{
  CGP::internal::Failure_reasons reasons;
  EXPECT_EQ(reasons.text(), "");
  for (const char* const name : {"a", "b", "c"}) reasons.add(name, "it is closed");
  reasons.add("d", "it is flat");
  EXPECT_EQ(reasons.text(), "a, b, c: it is closed; d: it is flat");
  for (const char* const name : {"e", "f", "g", "h"}) reasons.add(name, "it is closed");
  EXPECT_EQ(reasons.text(), "a, b, c, e, f and 2 more: it is closed; d: it is flat");
  EXPECT_EQ(reasons.size(), 8u);
}

TEST(Failure_reasons, of_ever_so_many_are_a_short_text)
{
  CGP::internal::Failure_reasons reasons;
  std::string expected;
  for (int i = 0; i < 100000; ++i) {
    const std::string name = "a" + std::to_string(i), reason = "r" + std::to_string(i);
    reasons.add(name, reason);
    if (i < 5) expected += name + ": " + reason + "; ";
  }
  EXPECT_EQ(reasons.text(), expected + "99995 more for other reasons");
  reasons.add("b", "r4");
  EXPECT_NE(reasons.text().find("; a4, b: r4; 99995 more for"), std::string::npos);
  EXPECT_EQ(reasons.size(), 100001u);
}

TEST(Component_failures, names_those_that_failed)
{
  CGP::internal::Component_failures failures(4, "some_function");
  failures.attempt(0, 0, [] {});
  failures.attempt(1, 7, [] { throw CGP::Solver_error("inner", "no factor"); });
  failures.attempt(3, 9, [] { throw CGP::Precondition_error("inner", "it is closed"); });
  try {
    failures.throw_if_any();
    FAIL();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(error.function(), "some_function");
    EXPECT_EQ(error.message(),
              "2 of 4 components failed (their elements are counted in each): component 1 (from "
              "vertex 7): no factor; component 3 (from vertex 9): it is closed");
  }
}

TEST(Component_failures, are_none_if_nothing_was_thrown)
{
  CGP::internal::Component_failures failures(1, "some_function");
  failures.attempt(0, 0, [] {});
  EXPECT_NO_THROW(failures.throw_if_any());
}

TEST(Component_failures, of_the_solver_alone_are_an_error_of_the_solver)
{
  CGP::internal::Component_failures failures(2, "some_function");
  failures.attempt(1, 7, [] { throw CGP::Solver_error("inner", "no factor"); });
  EXPECT_THROW(failures.throw_if_any(), CGP::Solver_error);
}

TEST(Component_failures, let_what_is_not_of_one_component_pass)
{
  CGP::internal::Component_failures failures(2, "some_function");
  EXPECT_THROW(failures.attempt(1, 7, [] { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_THROW(
      failures.attempt(1, 7, [] { throw CGP::Solver_error("inner", "failed: out of memory"); }),
      CGP::Solver_error);
  EXPECT_NO_THROW(failures.throw_if_any());
}

TEST(Component_failures, know_the_words_of_solvers_for_a_lack_of_memory)
{
  const auto is_of_memory = [](CGP::Solver_status status) {
    return CGP::is_out_of_memory({"inner", std::string("failed: ") + CGP::to_string(status)});
  };
  EXPECT_TRUE(is_of_memory(CGP::Solver_status::out_of_memory));
  EXPECT_FALSE(is_of_memory(CGP::Solver_status::not_positive_definite));
}

TEST(Component_reports, are_true_if_all_of_them_are)
{
  CGP::internal::Component_reports<bool> reports;
  EXPECT_TRUE(reports);
  reports.components.push_back({0, 4, 4, true});
  EXPECT_TRUE(reports);
  reports.components.push_back({4, 4, 4, false});
  EXPECT_FALSE(reports);
}

TEST(Mesh_components, of_selected_faces_keep_the_order_of_their_vertices)
{
  const Mesh_view mesh = surfaces_of_different_types().front();
  std::vector<char> is_selected(at(mesh.size_of_faces()), 0);
  for (int f = 0; f < mesh.size_of_faces(); f += 3) is_selected[at(f)] = 1;
  const CGP::internal::Mesh_component part = CGP::internal::selected_faces(mesh, is_selected);
  ASSERT_EQ(part.mesh.size_of_faces(), (mesh.size_of_faces() + 2) / 3);
  EXPECT_TRUE(std::is_sorted(part.vertices.begin(), part.vertices.end()));
  for (int f = 0; f < part.mesh.size_of_faces(); ++f) {
    EXPECT_EQ(part.faces[at(f)], 3 * f);
    for (std::size_t c = 0; c < 3; ++c) {
      const int v = part.mesh.corners(f)[c];
      EXPECT_EQ(part.vertices[at(v)], mesh.corners(3 * f)[c]);
      EXPECT_EQ(part.mesh.position(v), mesh.position(part.vertices[at(v)]));
    }
  }
}

}  // namespace cgp_test::mesh_component_tests
