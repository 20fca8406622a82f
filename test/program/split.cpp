// Tests examples/conformal/commands/split.cpp examples/conformal/repair/select_faces.cpp
// Tests examples/conformal/commands/numbered_outputs.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/polyhedra.h"
#include "support/several_components.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

namespace cgp_test::split_tests {

using namespace program_test;
using conformal::read_surface;

class Split : public Program {
 protected:
  nlohmann::json report() const { return read_json("r.json"); }
};

TEST_F(Split, writes_each_component_in_its_order)
{
  const std::vector<cgp_test::Mesh_view> parts = {cgp_test::icosphere(1), cgp_test::tetrahedron(),
                                                  cgp_test::disk(2)};
  write("a.off", off(cgp_test::interleaved(parts).mesh));
  ASSERT_EQ(run("split a.off -o b.off --json r.json").code, 0);
  EXPECT_EQ(report()["result"]["components"], 3);
  EXPECT_EQ(report()["result"]["files"][1], "b_0001.off");
  for (std::size_t p = 0; p < parts.size(); ++p) {
    write("one.off", off(parts[p]));
    const auto whole = read_surface(path("one.off"));
    const auto part = read_surface(path(report()["result"]["files"][p]));
    EXPECT_EQ(part.points, whole.points);
    EXPECT_EQ(part.polygons.corners, whole.polygons.corners);
  }
}

TEST_F(Split, leads_back_to_the_vertices_before)
{
  write("a.off", off(cgp_test::interleaved(
                         {cgp_test::icosphere(1), cgp_test::tetrahedron(), cgp_test::disk(2)})
                         .mesh));
  ASSERT_EQ(run("split a.off --min-faces 5 -o b.off --json r.json").code, 0);
  const auto whole = read_surface(path("a.off"));
  const auto result = report()["result"];
  std::size_t next = 0;
  for (std::size_t p = 0; p < 2; ++p) {  // without the tetrahedron
    const auto part = read_surface(path(result["files"][p]));
    ASSERT_EQ(result["vertices"][p], part.points.size());
    for (const auto& point : part.points)
      EXPECT_EQ(point, whole.points[result["vertex_before_split"][next++].get<std::size_t>()]);
  }
  EXPECT_EQ(result["vertex_before_split"].size(), next);
}

TEST_F(Split, keeps_properties_corners_and_materials)
{
  write("a.obj",
        "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 0 1 0\nv 5 0 0 0 0 1\nv 6 0 0 0 0 1\n"
        "v 6 1 0 0 0 1\nv 5 1 0 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3\n"
        "usemtl blue\nf 4/1 5/2 6/3 7/1\n");
  ASSERT_EQ(run("split a.obj -o b.obj -q").code, 0);
  const std::string second = content(path("b_0001.obj"));
  EXPECT_NE(second.find("usemtl blue\nf 1/1 2/2 3/3 4/1"), std::string::npos) << second;
  EXPECT_NE(second.find("v 5 0 0 0 0 1"), std::string::npos) << second;
  EXPECT_EQ(content(path("b_0000.obj")).find("v 5 0 0"), std::string::npos);
}

TEST_F(Split, leaves_out_crumbs_and_overwrites_no_input)
{
  write("b_0000.off",
        off(cgp_test::interleaved({cgp_test::tetrahedron(), cgp_test::disk(2)}).mesh));
  EXPECT_TRUE(fails(run("split b_0000.off -o b.off"), 2, "component 0 would be written over"));
  EXPECT_TRUE(fails(run("split b_0000.off --min-faces 1000 -o c.off"), 4, "--min-faces"));
  ASSERT_EQ(run("split b_0000.off --min-faces 5 -o c.off").code, 0);
  EXPECT_GT(read_surface(path("c_0000.off")).polygons.size(), 5u);
  EXPECT_FALSE(has("c_0001.off"));
}

TEST_F(Split, writes_all_parts_or_none)
{
  write("a.off", off(cgp_test::interleaved({cgp_test::tetrahedron(), cgp_test::disk(2)}).mesh));
  std::filesystem::create_directory(path("b_0001.off"));
  EXPECT_TRUE(fails(run("split a.off -o b.off"), 5, "b_0001.off: is a directory"));
  EXPECT_FALSE(has("b_0000.off"));
}

TEST_F(Split, notes_vertices_that_are_in_no_part)
{
  write("a.off", off(cgp_test::tetrahedron(), "7 8 9\n", 1));
  const Program_run r = run("split a.off -o b.off");
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.err,
            "conformal: note: 1 vertex without a face (first: vertex 0): no part of the surface\n");
}

}  // namespace cgp_test::split_tests
