// Tests examples/conformal/transform/suggested_factor.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"
#include "support/tori.h"

#include "conformal/process/text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cgp_test::suggested_factor_tests {

using namespace program_test;

using Suggested_factor = Program;

TEST_F(Suggested_factor, is_told_by_the_amplitude_with_which_a_refused_result_verifies)
{
  write("a.off", off(cgp_test::icosphere(3)));
  const std::string spin =
      "spin -q a.off --rho-expression 'sin(3*y)' --max-scale none "
      "--json b.json -o b.ply ";
  const Program_run r = run(spin + "--amplitude 4 --limit quasi_conformal=1.05");
  EXPECT_EQ(r.code, 1);
  const auto json = read_json("b.json");
  const double amplitude = json["result"]["suggested_amplitude"];
  EXPECT_GT(amplitude, 0);
  EXPECT_LT(amplitude, 4);
  const std::string advice = "--amplitude " + conformal::text_of(amplitude);
  EXPECT_NE(r.err.find("try: " + advice), std::string::npos) << r.err;
  EXPECT_EQ(run(spin + advice + " --limit quasi_conformal=1.05").code, 0);
  const std::string more = "--amplitude " + std::to_string(amplitude + .25);
  EXPECT_EQ(run(spin + more + " --limit quasi_conformal=1.05").code, 1);
}

TEST_F(Suggested_factor, is_left_out_where_nothing_smaller_verifies)
{
  write("a.off", off(cgp_test::icosphere(2)));
  const Program_run r =
      run("spin -q a.off --rho-expression 'x*y' --limit closure=1e-12 -o b.ply --json b.json");
  EXPECT_EQ(r.code, 1);
  const auto json = read_json("b.json");
  EXPECT_FALSE(json["result"].contains("suggested_amplitude"));
  EXPECT_EQ(r.err.find("with which it verifies"), std::string::npos) << r.err;
}

int count_of(const std::string& what, const std::string& text)
{
  int count = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += what.size()) ++count;
  return count;
}

TEST_F(Suggested_factor, is_looked_for_within_a_budget_of_solves_where_rho_is_wild)
{
  write("a.off", off(cgp_test::icosphere(3)));
  // from vertex to vertex, as noise
  const Program_run r =
      run("spin a.off --rho-expression '45*sin(1000*x)*cos(1100*y)' --max-scale 6 "
          "--advanced progress=json --json b.json -o b.ply");
  EXPECT_EQ(r.code, 1);
  const auto result = read_json("b.json")["result"];
  EXPECT_GT(result["solves"], 400);
  EXPECT_GE(result["suggestion_solves"], 1000);
  EXPECT_EQ(count_of(", factorization\"", r.err), 3) << "not four";
  EXPECT_EQ(count_of("this takes long: 250 iterations", r.err), 1) << "of more attempts";
  const auto note = r.err.find("looking for an amplitude"), first = r.err.find("rho times 0.5, ");
  EXPECT_LT(note, first) << r.err;
  EXPECT_NE(first, std::string::npos);
}

// The share that is left out does not depend on the amplitude, to first order.
TEST_F(Suggested_factor, is_not_looked_for_where_too_much_is_left_out_for_handles)
{
  write("a.off", off(cgp_test::torus(1, .4, 32, 16)));
  const std::string spin =
      "spin -q a.off --rho-expression 'sin(3*x+1)' --limit realised_share=.9999 --json b.json "
      "-o b.ply --amplitude ";
  std::vector<double> shares;
  for (const char* amplitude : {".3", ".03", ".003"}) {  // within the bound on lengths
    EXPECT_EQ(run(spin + amplitude).code, 1);
    const auto result = read_json("b.json")["result"];
    EXPECT_FALSE(result.contains("suggestion_solves"));
    shares.push_back(result["realised_share"]);
  }
  EXPECT_LT(shares[0], .9);
  EXPECT_LT(std::abs(shares[2] - shares[1]), .2 * std::abs(shares[1] - shares[0]));
}

// Each attempt begins with a line of progress of its factorization.
TEST_F(Suggested_factor, is_looked_for_on_other_triangles_only_where_there_are_others)
{
  const auto sphere = cgp_test::icosphere(2);  // Delaunay
  auto stretched = sphere.positions();
  stretched.row(0) *= 20;
  using Case = std::pair<decltype(stretched), int>;
  for (const auto& [points, attempts] : {Case{sphere.positions(), 1}, Case{stretched, 2}}) {
    auto mesh = sphere;
    mesh.set_positions(points);
    write("a.off", off(mesh));
    const Program_run r = run(
        "spin a.off --rho-expression 'x*y' --limit closure=1e-12 --force --advanced progress=json "
        "-o b.ply");
    EXPECT_EQ(count_of("\"stage\":\"factorization\"", r.err), attempts) << r.err;
  }
}

}  // namespace cgp_test::suggested_factor_tests
