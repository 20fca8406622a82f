// Tests examples/conformal/transform/write_result.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/read_surface.h"
#include "conformal/io/write_surface.h"
#include "program/support.h"
#include "support/spheres.h"

namespace cgp_test::write_result_tests {

using namespace program_test;
using conformal::read_surface;

using Write_result = Program;

TEST_F(Write_result, normals_of_before_are_left_out_and_that_is_told)
{
  auto a = read_surface(write("a.off", off(cgp_test::icosahedron())));
  for (const char* name : {"nx", "ny", "nz"})
    set_property(a.faces, name, std::vector<float>(a.faces.size, 1));
  conformal::write_surface(path("a.ply"), a);
  const std::string notes = run("spin a.ply --rho-expression z -o b.ply").err;
  EXPECT_NE(notes.find("normals"), std::string::npos) << notes;
  EXPECT_EQ(find_property(read_surface(path("b.ply")).faces, "nx"), nullptr);
}

class Ply_options : public program_test::Program {};

TEST_F(Ply_options, are_for_text_and_single_precision)
{
  write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  ASSERT_EQ(run("split a.off -o b.ply --advanced ascii --advanced float").code, 0);
  const std::string text = program_test::content(path("b_0000.ply"));
  EXPECT_EQ(text.substr(0, 38), "ply\nformat ascii 1.0\nelement vertex 3\n");
  EXPECT_NE(text.find("property float x"), std::string::npos);
  write("far.off", "OFF\n3 1 0\n1000000001 0 0\n1e9 1 0\n1e9 0 1\n3 0 1 2\n");
  EXPECT_TRUE(program_test::fails(run("split far.off -o c.ply --advanced float"), 5,
                                  "without --advanced float"));
}

}  // namespace cgp_test::write_result_tests
