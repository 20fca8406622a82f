// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests examples/conformal/commands/deform.cpp
// Tests examples/conformal/input/targets.cpp
#include "conformal/io/file/numbers.h"
#include "program/bounded_support.h"
#include "support/control_points.h"
#include "support/limbs.h"
#include "support/several_components.h"

namespace cgp_test::deform_tests {

using namespace program_test;
using Deform = Bounded_program;

std::string numbers(const Eigen::Vector3d& p)
{
  std::string text = "[";
  for (Eigen::Index i = 0; i < 3; ++i) {
    conformal::append_number(text, p[i]);
    text += i == 2 ? "]" : ", ";
  }
  return text;
}

/// targets that hold vertices, but move the second one
std::string targets(const cgp_test::Mesh_view& mesh, int count, double radii)
{
  std::string text;
  for (const auto& p : cgp_test::one_moved(mesh, count, radii))
    text += std::string(text.empty() ? "" : ", ") +
            "{\"vertex\": " + std::to_string(p.vertices[0]) + ", \"to\": " + numbers(p.target) +
            "}";
  return "{\"targets\": [" + text + "]}";
}

TEST_F(Deform, moves_vertices_to_their_targets)
{
  const auto mesh = cgp_test::dumbbell(2);
  write("a.off", off(mesh));
  write("t.json", targets(mesh, 6, .2));
  const Program_run r = run("deform a.off --targets t.json -o b.ply --json b.json --lambda q");
  ASSERT_EQ(r.code, 0) << r.err;
  const Points moved = points("b.ply");
  for (const auto& p : cgp_test::one_moved(mesh, 6, .2))
    EXPECT_LT((moved.col(p.vertices[0]) - p.target).norm(), 1e-6);  // of the numbers in the file
  const auto report = json("b.json");
  EXPECT_TRUE(report["verified"]);
  EXPECT_EQ(report["result"]["targets"]["reached"], 1);
  EXPECT_EQ(report["result"]["targets"]["count"], 6);
  EXPECT_LT(report["result"]["targets"]["distance"]["max"], 1e-7);
  const auto b = conformal::read_surface(path("b.ply"));
  for (const char* name : {"quality", "rho", "q_w"})
    EXPECT_NE(find_property(b.vertices, name), nullptr) << name;
}

TEST_F(Deform, moves_and_turns_boxes)
{
  write("a.off", off(cgp_test::dumbbell(2)));
  write("t.json", R"({"targets": [{"box": [[-9, -9, -9], [9, -1.5, 9]]},
                      {"box": [[-9, 1.5, -9], [9, 9, 9]], "move": [0.2, 0, 0],
                       "turn": [0, 0, 2, 20]}]})");
  const Program_run r = run("deform a.off --targets t.json -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(json("b.json")["result"]["targets"]["count"], 8);
  EXPECT_LT(json("b.json")["result"]["targets"]["distance"]["max"], 1e-7);
}

TEST_F(Deform, leaves_components_without_targets_alone)
{
  const auto one = cgp_test::dumbbell(1), two = cgp_test::moved(one, {9, 0, 0});
  const auto both = cgp_test::interleaved({one, two});
  write("a.off", off(both.mesh));
  const int v = both.vertices[0][3];
  write("t.json", "{\"targets\": [{\"vertex\": " + std::to_string(v) + ", \"to\": [0, 0, 0]}]}");
  const Program_run r = run("deform a.off --each-component --targets t.json -o b.ply");
  ASSERT_EQ(r.code, 0) << r.err;
  const Points moved = points("b.ply");
  EXPECT_LT(moved.col(v).norm(), 1e-6);
  for (int i = 0; i < two.size_of_vertices(); ++i)
    EXPECT_LT((moved.col(both.vertices[1][cgp_test::at(i)]) - two.position(i)).norm(), 1e-5);
}

TEST_F(Deform, changes_nothing_outside_of_a_region)
{
  const auto mesh = cgp_test::dumbbell(3);
  int top;
  mesh.positions().row(1).maxCoeff(&top);
  write("a.off", off(mesh));
  write("t.json",
        "{\"targets\": [{\"vertex\": " + std::to_string(top) + ", \"move\": [0.2, 0.1, 0]}]}");
  const std::string command = "deform a.off --targets t.json -o b.off --region-expression ";
  const Program_run r = run(command + "4*y --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const Points before = points("a.off"), moved = points("b.off");
  const double low = before.row(1).minCoeff(), middle = (low + before.row(1).maxCoeff()) / 2;
  int stay = 0;
  for (Eigen::Index v = 0; v < before.cols(); ++v)
    if (before(1, v) < middle - 1e-9) {
      EXPECT_EQ(moved.col(v), before.col(v)) << v;
      ++stay;
    }
  EXPECT_GT(stay, before.cols() / 3);
  EXPECT_LT((moved.col(top) - before.col(top) - Eigen::Vector3d(.2, .1, 0)).norm(), 1e-6);
  EXPECT_GT(json("b.json")["result"]["collar"]["quasi_conformal"]["max"], 1);
  EXPECT_TRUE(fails(run(command + "-4*y"), 4, "outside of the region"));
}

TEST_F(Deform, leaves_parts_of_a_region_without_targets_alone)
{
  const auto mesh = cgp_test::dumbbell(3);
  int top;
  mesh.positions().row(1).maxCoeff(&top);
  write("a.off", off(mesh));
  const std::string up =
      "{\"targets\": [{\"vertex\": " + std::to_string(top) + ", \"move\": [0.2, 0.1, 0]}";
  write("t.json", up + "]}");
  const std::string command =
      "deform a.off --targets t.json -o b.off --json b.json --region-expression '8*abs(y)-2'";
  const Program_run r = run(command);
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.err.find("has no target"), std::string::npos) << r.err;
  const Points before = points("a.off"), moved = points("b.off");
  const double middle = (before.row(1).minCoeff() + before.row(1).maxCoeff()) / 2;
  const int there = json("b.json")["result"]["region"]["vertices"];
  int above = 0;
  for (Eigen::Index v = 0; v < before.cols(); ++v) {
    EXPECT_TRUE(before(1, v) >= middle || moved.col(v) == before.col(v)) << v;
    above += before(1, v) > middle;
  }
  EXPECT_GT(there, 0);
  EXPECT_LT(there, above);
  int bottom;
  mesh.positions().row(1).minCoeff(&bottom);
  write("t.json", up + ", {\"vertex\": " + std::to_string(bottom) + ", \"move\": [0, 0, 0]}]}");
  EXPECT_TRUE(fails(run(command), 4, "2 parts with targets"));
}

TEST_F(Deform, tells_how_far_it_comes)
{
  const auto mesh = cgp_test::dumbbell(1);
  write("a.off", off(mesh));
  write("t.json", targets(mesh, 8, 8));
  EXPECT_TRUE(fails(run("deform a.off --targets t.json -o b.ply"), 1, "% of the way"));
  EXPECT_FALSE(has("b.ply"));
}

TEST_F(Deform, names_the_target_that_makes_no_sense)
{
  write("a.off", off(cgp_test::dumbbell(1)));
  const auto is_refused = [&](const std::string& targets, int code, const std::string& words) {
    write("t.json", "{\"targets\": [" + targets + "]}");
    EXPECT_TRUE(fails(run("deform a.off --targets t.json -o b.ply"), code, words)) << targets;
    EXPECT_FALSE(has("b.ply"));
  };
  const std::string good = "{\"vertex\": 0, \"to\": [0, 0, 0]}, ";
  is_refused("", 3, "has no targets");
  is_refused(good, 3, "is not JSON");
  is_refused(good + R"({"vertex": 999, "to": [0, 0, 0]})", 4, "target 1 is for vertex 999");
  is_refused(good + R"({"vertex": -1, "to": [0, 0, 0]})", 4, "target 1 is for vertex -1");
  is_refused(good + R"({"vertex": 0, "move": [0, 0, 0]})", 3, "same vertex as target 0");
  is_refused(good + R"({"vertex": 1.5, "to": [0, 0, 0]})", 3, "whole number");
  is_refused(good + R"({"vertex": 1, "to": [0, NaN, 0]})", 3, "is not JSON");
  is_refused(good + R"({"vertex": 1, "to": [0, 1e999, 0]})", 3, "a number that is out of range");
  is_refused(good + R"({"vertex": 1, "to": [0, null, 0]})", 3, "not 3 numbers");
  is_refused(good + R"({"vertex": 1, "to": [0, 0]})", 3, "not 3 numbers");
  is_refused(good + R"({"box": [[50, 50, 50], [51, 51, 51]]})", 4, "box without any vertex");
  is_refused(good + R"({"box": [1, 2]})", 3, "\"box\"");
  is_refused(good + R"({"vertex": 1, "too": [0, 0, 0]})", 3, "unknown key \"too\"");
  is_refused(good + R"({"move": [0, 0, 0]})", 3, "needs one of");
  is_refused(good + R"({"vertices": [1, 2], "to": [0, 0, 0]})", 3, "\"to\"");
  is_refused(good + R"({"vertices": [1, 2], "turn": [0, 0, 0, 9]})", 3, "without an axis");
  EXPECT_TRUE(fails(run("deform a.off --targets none.json -o b.ply"), 3, "none.json"));
}

}  // namespace cgp_test::deform_tests
