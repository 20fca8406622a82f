// Tests examples/conformal/commands/harmonic.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/handlebodies.h"
#include "support/spheres.h"
#include "support/tori.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace cgp_test::harmonic_tests {

using namespace program_test;
using conformal::read_surface;

using Harmonic = Program;

std::string field_name(int form, const char* axis)
{
  return "harmonic_" + std::to_string(form) + axis;
}

/// the vector of face f in the properties of a form
Eigen::Vector3d field(const conformal::Surface_file& file, int form, std::size_t f)
{
  Eigen::Vector3d v;
  const char* const axes[] = {"_x", "_y", "_z"};
  for (Eigen::Index i = 0; i < 3; ++i)
    v[i] = find_property(file.faces, field_name(form, axes[i]))->value(f);
  return v;
}

TEST_F(Harmonic, tells_genus_residuals_and_the_modulus_of_a_torus)
{
  write("a.off", off(cgp_test::torus(2.5, 1, 48, 24)));
  const Program_run r = run("harmonic a.off --json a.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto json = read_json("a.json");
  EXPECT_EQ(json["command"], "harmonic");
  EXPECT_EQ(json["input"]["genus"], 1);
  EXPECT_EQ(json["result"]["genus"], 1);
  EXPECT_EQ(json["result"]["forms"], 2);
  for (const char* place : {"closed_residual", "coclosed_residual", "orthonormal_residual"})
    EXPECT_LT(json["result"][place], 1e-12) << place;
  EXPECT_NEAR(json["result"]["conformal_modulus"]["real"], 0, 0.02);
  EXPECT_NEAR(json["result"]["conformal_modulus"]["imaginary"], std::sqrt(2.5 * 2.5 - 1), 0.02);
  for (const char* stage : {"read", "solve", "measure", "total"})
    EXPECT_TRUE(json["seconds"].at(stage).is_number()) << stage;
  EXPECT_NE(r.out.find("conformal modulus"), std::string::npos) << r.out;
}

TEST_F(Harmonic, writes_orthonormal_fields_in_the_planes_of_the_faces)
{
  const auto mesh = cgp_test::scaled(cgp_test::smooth_handlebody(2, 1), 30);
  write("a.off", off(mesh));
  ASSERT_EQ(run("harmonic a.off -o b.ply --json b.json").code, 0);
  const auto b = read_surface(path("b.ply"));
  EXPECT_EQ(b.polygons.corners, read_surface(path("a.off")).polygons.corners);
  Eigen::Matrix4d gram = Eigen::Matrix4d::Zero();
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::Matrix<double, 4, 3> v;
    for (int i = 0; i < 4; ++i) v.row(i) = field(b, i, cgp_test::at(f)).transpose();
    gram += mesh.double_area_vector(f).norm() / 2 * v * v.transpose();
    EXPECT_LT((v * mesh.double_area_vector(f).normalized()).norm(), 1e-12);
  }
  EXPECT_LT((gram - Eigen::Matrix4d::Identity()).norm(), 1e-10);
  const auto json = read_json("b.json");
  EXPECT_FALSE(json["result"].contains("conformal_modulus"));
}

TEST_F(Harmonic, writes_only_the_form_asked_for)
{
  write("a.off", off(cgp_test::btorus(8)));
  ASSERT_EQ(run("harmonic -q a.off --form 1 -o b.ply").code, 0);
  const auto b = read_surface(path("b.ply"));
  EXPECT_EQ(find_property(b.faces, "harmonic_0_x"), nullptr);
  EXPECT_NE(find_property(b.faces, "harmonic_1_x"), nullptr);
  EXPECT_TRUE(fails(run("harmonic a.off --form 2"), 2, "no form 2; try: --form 0 to 1"));
  EXPECT_TRUE(fails(run("harmonic a.off --form -1"), 2, "--form"));
}

TEST_F(Harmonic, says_what_a_format_cannot_hold)
{
  write("a.off", off(cgp_test::btorus(6)));
  const Program_run r = run("harmonic a.off -o b.off");
  ASSERT_EQ(r.code, 0);
  EXPECT_NE(r.err.find("harmonic_0_x"), std::string::npos) << r.err;
}

TEST_F(Harmonic, gives_polygons_the_mean_of_their_triangles)
{
  // the surface of a square ring of cubes, 3 x 3 x 1 without the middle, in quads
  std::string text;
  const auto ring = cgp_test::holed_block(1);
  text = "OFF\n" + std::to_string(ring.size_of_vertices()) + ' ' +
         std::to_string(ring.size_of_faces() / 2) + " 0\n";
  for (int v = 0; v < ring.size_of_vertices(); ++v)
    for (Eigen::Index i = 0; i < 3; ++i)
      text += std::to_string(ring.position(v)[i]) + (i == 2 ? '\n' : ' ');
  for (int f = 0; f < ring.size_of_faces(); f += 2) {
    // two triangles (a, b, c) and (a, c, d), in any rotation: the corner of the second that is new
    const auto& s = ring.corners(f);
    const auto& t = ring.corners(f + 1);
    std::vector<int> quad;
    for (std::size_t i = 0; i < 3; ++i) {
      quad.push_back(s[i]);
      for (std::size_t j = 0; j < 3; ++j)
        if (t[j] == s[(i + 1) % 3] && t[(j + 1) % 3] == s[i]) quad.push_back(t[(j + 2) % 3]);
    }
    ASSERT_EQ(quad.size(), 4u);
    text += '4';
    for (const int v : quad) text += ' ' + std::to_string(v);
    text += '\n';
  }
  write("a.off", text);
  ASSERT_EQ(run("harmonic a.off -o b.ply").code, 0);
  const auto b = read_surface(path("b.ply"));
  EXPECT_EQ(b.polygons.size(), 32u);
  EXPECT_EQ(b.faces.size, 32u);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // all squares have the area 1
  for (std::size_t f = 0; f < 32; ++f) sum += field(b, 0, f);
  EXPECT_LT(sum.norm(), 1e-12);
}

TEST_F(Harmonic, two_runs_write_the_same_bytes)
{
  write("a.off", off(cgp_test::btorus(12)));
  for (const std::string name : {"b.ply", "c.ply"})
    ASSERT_EQ(run("harmonic a.off -o " + name).code, 0);
  EXPECT_EQ(content(path("b.ply")), content(path("c.ply")));
}

TEST_F(Harmonic, refuses_spheres_and_boundaries)
{
  write("sphere.off", off(cgp_test::icosphere(1)));
  write("open.off", off(cgp_test::without_face(cgp_test::btorus(6), 3)));
  EXPECT_TRUE(fails(run("harmonic sphere.off -o b.ply"), 4, "genus 0"));
  EXPECT_TRUE(fails(run("harmonic open.off -o b.ply"), 4, "boundary"));
  EXPECT_FALSE(has("b.ply"));
}

// Two vertices so far away that the digits do not suffice for their edges and the others.
TEST_F(Harmonic, writes_nothing_that_is_not_harmonic)
{
  cgp_test::Points points = cgp_test::torus(2, 0.7, 10, 6).positions();
  points(0, 7) = points(0, 30) = -1e12;
  write("a.off", off({points, cgp_test::torus(2, 0.7, 10, 6).corners()}));
  const Program_run r = run("harmonic a.off -o b.ply --json b.json");
  EXPECT_TRUE(fails(r, 1, "residual of the forms"));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_FALSE(read_json("b.json")["verified"]);
}

TEST_F(Harmonic, has_help_with_an_example)
{
  const Program_run r = run("harmonic --help");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.out.find("Example: conformal harmonic"), std::string::npos);
}

}  // namespace cgp_test::harmonic_tests
