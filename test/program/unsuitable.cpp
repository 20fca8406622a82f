// Tests examples/conformal/input/Defects.cpp examples/conformal/commands/info.cpp
// Tests examples/conformal/report/Shape.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/bounded_meshes.h"
#include "support/polyhedra.h"
#include "support/spheres.h"
#include "support/tori.h"

namespace cgp_test::unsuitable_tests {

using namespace program_test;

class Unsuitable : public Program {
 protected:
  /// `spin` rejects the mesh with these words and writes nothing; `info` prints them and continues
  void refused(const std::string& name, const std::string& text, const std::string& words)
  {
    write(name, text);
    EXPECT_TRUE(fails(run("spin -q " + name + " --rho-expression x -o out.ply"), 4, words));
    EXPECT_FALSE(has("out.ply"));
    EXPECT_EQ(run("info " + name).code, 0);
    EXPECT_EQ(run("info --advanced strict " + name).code, 4);
  }
};

TEST_F(Unsuitable, three_faces_on_an_edge)
{
  refused("fan3.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n",
          "1 non-manifold edge where more than two faces meet (first: the edge from vertex 0 "
          "(number 1 in the OBJ file) to vertex 1");
}

TEST_F(Unsuitable, two_fans_at_a_vertex)
{
  refused("hourglass.off",
          "OFF\n7 8 0\n0 0 0\n1 0 1\n-1 1 1\n-1 -1 1\n1 0 -1\n-1 1 -1\n-1 -1 -1\n"
          "3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n3 0 5 4\n3 0 6 5\n3 0 4 6\n3 4 5 6\n",
          "1 non-manifold vertex where several fans of faces touch (first: vertex 0)");
}

TEST_F(Unsuitable, moebius_strip)
{
  refused("moebius.off",
          "OFF\n6 6 0\n1 0 0\n0 1 0\n-1 0 0\n1 0 1\n0 1 1\n-1 0 1\n"
          "3 0 1 3\n3 1 4 3\n3 1 2 4\n3 2 5 4\n3 2 3 5\n3 3 0 5\n",
          "not orientable");
}

TEST_F(Unsuitable, two_components)
{
  const auto s = cgp_test::icosahedron();
  refused("two.off", off(cgp_test::disjoint_union(s, s, {5, 0, 0})),
          "2 components (the second begins at vertex 12)");
}

TEST_F(Unsuitable, faces_of_area_zero)
{
  auto mesh = cgp_test::icosahedron();
  auto points = mesh.positions();
  points.col(11) = points.col(5);
  mesh.set_positions(points);
  refused("flat.off", off(mesh), "2 faces of area zero (first: face 0)");
}

TEST_F(Unsuitable, boundary_for_commands_that_want_none)
{
  write("disk.off", off(cgp_test::without_face(cgp_test::icosahedron(), 3)));
  EXPECT_TRUE(
      fails(run("harmonic disk.off"), 4,
            "a closed surface is wanted, this one has V 12, E 30, F 19, 1 boundary loop, genus 0"));
  EXPECT_TRUE(fails(run("harmonic disk.off"), 4, "3 boundary edges (first: the edge from"));
  EXPECT_EQ(run("info --advanced strict disk.off").code, 0);
}

TEST_F(Unsuitable, info_tells_the_boundary_loops)
{
  write("ring.off", off(cgp_test::annulus(0.5, 1, 40, 4), "7 8 9\n", 1));
  const Program_run r = run("info ring.off --json info.json");
  EXPECT_NE(r.out.find("boundary loop 1                   40 vertices, length 3.138"),
            std::string::npos)
      << r.out;
  EXPECT_NE(r.out.find("from vertex 161\n"), std::string::npos) << r.out;
  const std::string json = content(path("info.json"));
  EXPECT_NE(json.find("\"problems\": []"), std::string::npos) << json;
}

TEST_F(Unsuitable, repairs_are_forbidden_by_strict)
{
  write("cube.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  EXPECT_TRUE(fails(run("spin --advanced strict -q cube.obj --rho-expression x -o b.ply"), 4,
                    "6 polygons triangulated"));
}

TEST_F(Unsuitable, info_counts_what_is_there)
{
  write("torus.off", off(cgp_test::torus(2, 1, 12, 8)));
  const Program_run r = run("info torus.off --json info.json");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.out.find("genus                             1\n"), std::string::npos) << r.out;
  const std::string json = content(path("info.json"));
  for (const char* part : {"\"command\": \"info\"", "\"vertices\": 96", "\"faces\": 192",
                           "\"boundary_loops\": 0", "\"genus\": 1", "\"problems\": []"})
    EXPECT_NE(json.find(part), std::string::npos) << part << json;
}

TEST_F(Unsuitable, info_measures_a_cube_of_any_size)
{
  for (const double size : {1., 1e-100, 1e90}) {
    write("cube.off", off(cgp_test::scaled(cgp_test::cube(), size)));
    const Program_run r = run("info cube.off");
    EXPECT_NE(r.out.find("smallest angle (degrees)          45\n"), std::string::npos) << r.out;
    EXPECT_EQ(r.out.find("nan"), std::string::npos) << r.out;
  }
}

}  // namespace cgp_test::unsuitable_tests
