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

}  // namespace cgp_test::write_result_tests
