// Tests examples/conformal/commands/spectrum.cpp examples/conformal/commands/sphere.cpp
// Tests examples/conformal/commands/option_checks.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace cgp_test::spectrum_tests {

using namespace program_test;

using Spectrum = Program;
using Sphere = Program;

TEST_F(Spectrum, tells_eigenvalues_with_their_multiplicities)
{
  write("a.off", off(cgp_test::scaled(cgp_test::icosphere(2), 2)));
  const Program_run r = run("spectrum a.off --count 7 --csv a.csv --json a.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto json = read_json("a.json");
  const std::vector<double> values = json["result"]["eigenvalues"];
  const double expected[] = {0, .5, .5, -1, 1, 1, 1};
  ASSERT_EQ(values.size(), 7u);
  for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(values[k], expected[k], 0.06) << k;
  EXPECT_LT(json["result"]["residual"], 1e-6);
  EXPECT_TRUE(json["result"]["is_complete"]);
  const double reach = json["result"]["complete_to"];
  EXPECT_GE(reach, 1);
  EXPECT_LT(reach, 1.6);  // the next ones are 1.5 and -1.5
  EXPECT_EQ(json["result"]["complete_from"], -reach);
  EXPECT_NE(r.out.find("complete to"), std::string::npos);
  std::istringstream csv(content(path("a.csv")));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "number,eigenvalue,pencil_eigenvalue,residual");
  int rows = 0;
  for (; std::getline(csv, line); ++rows)
    EXPECT_NEAR(std::stod(line.substr(line.find(',') + 1)), values[static_cast<std::size_t>(rows)],
                1e-15);
  EXPECT_EQ(rows, 7);
  std::istringstream table(r.out);
  std::getline(table, line);
  std::vector<int> multiplicities;
  for (double value = 0, count = 0; table >> value >> count;)
    multiplicities.push_back(static_cast<int>(count));
  EXPECT_EQ(multiplicities, (std::vector<int>{1, 1, 2, 3}));
}

TEST_F(Spectrum, says_that_the_mesh_does_not_resolve_what_was_asked_for)
{
  write("a.off", off(cgp_test::icosphere(1)));
  const Program_run r = run("spectrum a.off --count 42 --json a.json");
  EXPECT_EQ(r.code, 1);
  EXPECT_NE(r.err.find("of the 42 eigenvalues that were asked for"), std::string::npos) << r.err;
  const auto json = read_json("a.json");
  EXPECT_FALSE(json["result"]["is_complete"]);
  EXPECT_FALSE(json["verified"]);
  EXPECT_GE(json["result"]["eigenvalues"].size(), 7u);  // what was found is told all the same
  EXPECT_TRUE(fails(run("spectrum a.off --count 42 --surface 41 -o b.ply"), 1, "was not found"));
  EXPECT_EQ(run("spectrum a.off --count 42 --force --csv a.csv").code, 0);
}

TEST_F(Spectrum, says_that_many_eigenvalues_take_long)
{
  write("a.off", off(cgp_test::icosphere(2)));
  for (const int count : {79, 80}) {
    const Program_run r = run("spectrum a.off --count " + std::to_string(count));
    EXPECT_EQ(r.err.find("this takes long: 80 eigenvalues") != std::string::npos, count == 80)
        << r.err;
  }
}

TEST_F(Spectrum, next_to_a_shift_and_with_a_boundary)
{
  write("a.off", off(cgp_test::disk(8)));
  ASSERT_EQ(run("spectrum -q a.off --count 3 --shift 2.1 --json a.json").code, 0);
  const auto json = read_json("a.json");
  const std::vector<double> values = json["result"]["pencil_eigenvalues"];
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_NEAR(sorted[0], 1.83705, 1e-4);
  EXPECT_NEAR(sorted[2], 2.43107, 1e-4);
}

TEST_F(Spectrum, writes_the_surface_of_an_eigenfunction)
{
  write("a.off", off(cgp_test::icosphere(2)));
  ASSERT_EQ(run("spectrum -q a.off --count 4 --surface 3 -o b.ply").code, 0);
  const auto a = conformal::read_surface(path("a.off")), b = conformal::read_surface(path("b.ply"));
  EXPECT_EQ(a.polygons.corners, b.polygons.corners);
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_NE(find_property(b.vertices, "quality"), nullptr);
  // The eigenvalue -2 belongs to the normals: lambda = N turns the sphere inside out.
  for (std::size_t v = 0; v < a.points.size(); ++v)
    EXPECT_NEAR(std::hypot(b.points[v][0], b.points[v][1], b.points[v][2]), 1, 0.01);
}

TEST_F(Spectrum, refuses_what_it_cannot_do)
{
  write("a.off", off(cgp_test::icosphere(0)));
  EXPECT_TRUE(fails(run("spectrum a.off --count 13"), 2, "only 12 vertices"));
  EXPECT_TRUE(fails(run("spectrum a.off --count 3 --surface 3 -o b.ply"), 2, "no eigenfunction 3"));
  EXPECT_TRUE(fails(run("spectrum a.off -o b.ply"), 2, "--surface"));
  EXPECT_TRUE(fails(run("spectrum a.off --count 0"), 2, "--count"));
  EXPECT_TRUE(fails(run("spectrum none.off"), 3, "none.off"));
  EXPECT_TRUE(fails(run("spectrum a.off --csv none/b.csv"), 5, "none/b.csv"));
  EXPECT_EQ(temporary_files(), 0u);
}

TEST_F(Sphere, has_the_eigenvalue_and_the_energy_of_its_kappa)
{
  const Program_run r = run("sphere --kappa -2 --s 0 --level 4 -o a.ply --json a.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto json = read_json("a.json");
  EXPECT_NEAR(json["result"]["eigenvalue"], 1, 2e-3);
  EXPECT_NEAR(json["result"]["willmore_energy"], 4, 0.04);
  EXPECT_NE(r.out.find("Willmore energy"), std::string::npos);
  EXPECT_EQ(conformal::read_surface(path("a.ply")).polygons.size(), 20u * 16 * 16);
}

TEST_F(Sphere, refuses_numbers_that_do_not_belong_to_one)
{
  EXPECT_TRUE(fails(run("sphere --kappa 0 -o a.ply"), 2, "kappa is zero"));
  EXPECT_TRUE(fails(run("sphere --kappa 2 --s 2 -o a.ply"), 2, "wanted -2 to 1"));
  EXPECT_TRUE(fails(run("sphere --level 10 -o a.ply"), 2, "--level"));
  EXPECT_TRUE(fails(run("sphere --kappa 2"), 2, "--output"));
  EXPECT_TRUE(fails(run("sphere --kappa -40 --level 3 -o a.ply"), 1, "error: the mean quasi"));
  EXPECT_FALSE(has("a.ply"));
}

}  // namespace cgp_test::spectrum_tests
