// Tests examples/conformal/commands/compare.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/meshes.h"
#include "support/spheres.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

namespace cgp_test::compare_tests {

using namespace program_test;

using Compare = Program;

TEST_F(Compare, similar_meshes_are_perfect)
{
  const auto mesh = cgp_test::bumpy_sphere(2);
  write("a.off", off(mesh));
  write("b.off", off(cgp_test::scaled(mesh, 5)));
  const Program_run r = run("compare a.off b.off --json c.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto result = read_json("c.json")["result"];
  EXPECT_NEAR(result["quasi_conformal"]["max"], 1, 1e-9);
  EXPECT_NEAR(result["length_cross_ratio"]["max"], 0, 1e-9);
  EXPECT_NEAR(result["scale"]["min"], 5, 1e-9);
  EXPECT_NEAR(result["similarity_distance"]["max"], 0, 1e-9);
  EXPECT_EQ(result["flipped_faces"], 0);
  EXPECT_NEAR(result["quasi_conformal"]["histogram"]["share"][0], 1, 1e-12);
}

TEST_F(Compare, a_stretch_by_two_has_error_two_at_most)
{
  const auto mesh = cgp_test::icosphere(2);
  auto points = mesh.positions();
  points.row(2) *= 2;
  write("a.off", off(mesh));
  write("b.off", off({points, mesh.corners()}));
  ASSERT_EQ(run("compare a.off b.off --json c.json -o q.ply").code, 0);
  const auto result = read_json("c.json")["result"];
  EXPECT_NEAR(result["quasi_conformal"]["max"], 2, 0.05);
  const auto q = conformal::read_surface(path("q.ply"));
  EXPECT_NE(find_property(q.vertices, "quality"), nullptr);
  EXPECT_EQ(q.points[7][2], points(2, 7));
}

TEST_F(Compare, the_identity_flips_nothing_though_the_mesh_has_folds)
{
  const auto disk = cgp_test::disk(3);
  auto points = disk.positions();
  points.col(0) << .4, 0, 0;  // pulled over an edge: two faces are turned over
  write("flat.off", off(disk));
  write("folded.off", off({points, disk.corners()}));
  const auto flips = [&](const std::string& before, const std::string& after) -> int {
    EXPECT_EQ(run("compare " + before + ' ' + after + " --json c.json").code, 0);
    return read_json("c.json")["result"]["flipped_faces"];
  };
  EXPECT_EQ(flips("folded.off", "folded.off"), 0);
  EXPECT_EQ(flips("flat.off", "folded.off"), 2);
  EXPECT_EQ(flips("folded.off", "flat.off"), 2);
}

TEST_F(Compare, other_faces_are_refused_with_the_first_difference)
{
  write("a.off", off(cgp_test::icosphere(1)));
  write("b.off", off(cgp_test::icosphere(2)));
  EXPECT_TRUE(fails(run("compare a.off b.off"), 4, "162 vertices, wanted 42"));
  auto corners = cgp_test::icosphere(1).corners();
  std::swap(corners[3], corners[4]);
  write("c.off", off({cgp_test::icosphere(1).positions(), corners}));
  EXPECT_TRUE(fails(run("compare a.off c.off"), 4, "face 3 has the vertices"));
}

}  // namespace cgp_test::compare_tests
