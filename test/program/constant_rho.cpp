// Tests examples/conformal/commands/spin.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace cgp_test::constant_rho_tests {

using namespace program_test;

class Constant_rho : public Program {
 protected:
  Constant_rho() { write("a.off", off(cgp_test::bumpy_sphere(2))); }

  bool is_noted(const std::string& arguments, const std::string& input = "a.off") const
  {
    const Program_run r = run("spin " + input + " -o b.ply --json b.json " + arguments);
    EXPECT_EQ(r.code, 0) << r.err;
    const std::string note = "rho is constant (";
    const bool is_told = r.err.find("conformal: note: " + note) != std::string::npos;
    const nlohmann::json report = read_json("b.json");
    bool is_reported = false;
    for (const std::string text : report["notes"]) is_reported |= text.find(note) == 0;
    EXPECT_EQ(is_told, is_reported);
    return is_told;
  }
};

TEST_F(Constant_rho, is_noted_and_changes_nothing)
{
  EXPECT_TRUE(is_noted("--rho-expression 3"));
  const auto a = conformal::read_surface(path("a.off")), b = conformal::read_surface(path("b.ply"));
  for (std::size_t v = 0; v < a.points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.points[v][i], b.points[v][i], 1e-6);
  EXPECT_TRUE(is_noted("--rho-expression 0"));
  EXPECT_TRUE(is_noted("--rho-expression 'sin(x)^2+cos(x)^2' --on faces"));
  EXPECT_TRUE(is_noted("--rho-expression x --amplitude 0"));
}

TEST_F(Constant_rho, is_not_noted_where_something_else_is_wanted)
{
  EXPECT_FALSE(is_noted("--rho-expression x"));
  write("disk.off", off(cgp_test::disk(4)));
  EXPECT_FALSE(is_noted("--rho-expression .1", "disk.off"));
  EXPECT_FALSE(is_noted("--rho-expression '1e-6*x'"));
  EXPECT_FALSE(is_noted("--rho-expression 0 --target-scale-expression 'exp(.1*x)'"));
}

}  // namespace cgp_test::constant_rho_tests
