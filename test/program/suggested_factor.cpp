// Tests examples/conformal/transform/suggested_factor.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"

#include "conformal/process/text.h"

#include <nlohmann/json.hpp>

#include <string>

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

}  // namespace cgp_test::suggested_factor_tests
