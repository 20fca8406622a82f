// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests examples/conformal/commands/spin.cpp examples/conformal/commands/scale_options.cpp
#include <nlohmann/json.hpp>

#include <string>

#include "program/support.h"
#include "support/limbs.h"
#include "support/tori.h"

namespace cgp_test::spin_scales_tests {

using namespace program_test;

using Spin_scales = Program;

TEST_F(Spin_scales, lengths_stay_within_a_bound_of_two)
{
  write("a.off", off(cgp_test::dumbbell(3)));
  const std::string rho = "spin a.off --rho-expression '6*sin(4*y+.4)' --force ";
  ASSERT_EQ(run(rho + "-o b.ply --json b.json").code, 0);
  const auto bounded = read_json("b.json")["result"];
  EXPECT_GE(bounded["scale_control"]["low"], .5);
  EXPECT_LE(bounded["scale_control"]["high"], 2);
  EXPECT_GT(bounded["scale_control"]["weight"], 0);
  EXPECT_LT(bounded["scale_control"]["kept_norm"], 1);
  ASSERT_EQ(run(rho + "--max-scale none -o c.ply --json c.json").code, 0);
  const auto plain = read_json("c.json")["result"];
  EXPECT_FALSE(plain.contains("scale_control"));
  EXPECT_LT(plain["scale"]["min"], .5);
}

TEST_F(Spin_scales, a_bound_is_the_default_where_a_wish_is_followed)
{
  const auto has_default = [&](const std::string& command, const std::string& bound) {
    const std::string help = run(command + " --help").out;
    return help.find("--max-scale TEXT:FLOAT > 1 or none=" + bound + '\n') != std::string::npos;
  };
  for (const char* command : {"spin", "deform"}) EXPECT_TRUE(has_default(command, "2")) << command;
  for (const char* command : {"fit", "blend"}) EXPECT_TRUE(has_default(command, "none")) << command;
}

TEST_F(Spin_scales, sizes_that_are_wanted_come_without_a_bound_to_choose)
{
  write("a.off", off(cgp_test::dumbbell(3)));
  ASSERT_EQ(run("spin a.off --rho-expression 0 -o b.ply --json b.json "
                "--target-scale-expression 'exp(.35*tanh(4*y))'")
                .code,
            0);
  const auto report = read_json("b.json");
  EXPECT_EQ(report["options"]["max-scale"], "1.25");
  EXPECT_LE(report["result"]["scale_control"]["high"], 1.25);
  const auto scale = report["result"]["scale"];  // wanted: 2.01
  EXPECT_GT(scale["max"].get<double>() / scale["min"].get<double>(), 1.3);
}

TEST_F(Spin_scales, sizes_can_be_wanted_and_locked)
{
  write("a.off", off(cgp_test::dumbbell(3)));
  const Program_run r =
      run("spin a.off --rho-expression 0 --max-scale 1.3 -o b.ply --json b.json "
          "--target-scale-expression 'exp(.35*tanh(4*y))' --lock-expression 'y<0'");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto scale = read_json("b.json")["result"]["scale"];
  EXPECT_GT(scale["max"].get<double>() / scale["min"].get<double>(), 1.4);
  EXPECT_TRUE(fails(run("spin a.off --rho-expression 0 -o c.ply --max-scale none "
                        "--lock-expression 1"),
                    2, "without --max-scale none"));
  EXPECT_TRUE(fails(run("spin a.off --rho-expression 0 -o c.ply --max-scale 1"), 2, "above 1"));
  EXPECT_TRUE(fails(run("spin a.off --rho-expression 0 -o c.ply --target-scale-expression y"), 4,
                    "factors of lengths"));
}

TEST_F(Spin_scales, exact_class_keeps_length_cross_ratios_with_and_without_a_bound)
{
  write("a.off", off(cgp_test::irregular_torus(2, 1, 24, 12)));
  for (const std::string bound : {"1.3", "none"}) {
    const std::string spin = "spin -q a.off --rho-expression 'sin(3*x)' --max-scale " + bound +
                             " -o b.ply --json b.json";
    ASSERT_EQ(run(spin + " --exact-class").code, 0);
    const auto result = read_json("b.json")["result"];
    EXPECT_TRUE(result["exact_class"]["reached"]);
    EXPECT_GT(result["exact_class"]["length_cross_ratio"]["before"], 1e-4);
    EXPECT_LT(result["exact_class"]["length_cross_ratio"]["after"], 1e-10);
    EXPECT_LT(result["length_cross_ratio"]["max"], 1e-10);
    ASSERT_EQ(run(spin).code, 0);
    EXPECT_GT(read_json("b.json")["result"]["length_cross_ratio"]["max"], 1e-4);
    EXPECT_FALSE(read_json("b.json")["result"].contains("exact_class"));
  }
}

TEST_F(Spin_scales, the_realised_change_of_curvature_is_told_and_noted_where_it_falls_short)
{
  write("a.off", off(cgp_test::dumbbell(3)));
  const Program_run weak = run("spin a.off --rho-expression 'sin(5*x)' -o b.ply --json b.json");
  ASSERT_EQ(weak.code, 0);
  const auto good = read_json("b.json")["result"]["realised_curvature"];
  EXPECT_GT(good["agreement"], .8);
  EXPECT_EQ(good["least_agreement"], .5);
  EXPECT_EQ(good["wrong_sign"], 0);
  EXPECT_EQ(weak.err.find("the curvature has changed by"), std::string::npos);
  const Program_run bounded =
      run("spin a.off --rho-expression '6*sin(4*y+.4)' --max-scale 1.05 -o b.ply --json b.json "
          "--limit kept_norm=0");
  ASSERT_EQ(bounded.code, 0);
  const auto poor = read_json("b.json")["result"]["realised_curvature"];
  EXPECT_LT(poor["agreement"], .5);
  EXPECT_GT(poor["left_out"], .3);
  EXPECT_NE(bounded.err.find("the curvature has changed by"), std::string::npos);
  EXPECT_NE(bounded.err.find("a larger --max-scale"), std::string::npos);
}

}  // namespace cgp_test::spin_scales_tests
