// Tests examples/conformal/commands/curve.cpp examples/conformal/curves/curve_report.cpp
// Tests examples/conformal/curves/Curve_flows.cpp examples/conformal/curves/Pictures.cpp
// Tests examples/conformal/curves/refine_curve.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/plane_curves.h"

#include "conformal/io/file/numbers.h"
#include "conformal/io/read_plane_curves.h"

#include <nlohmann/json.hpp>

namespace cgp_test::curve_tests {

using namespace program_test;
using cgp_test::Curve;

class Curve_command : public Program {
 protected:
  nlohmann::json json(const std::string& name) const { return read_json(name); }

  std::vector<conformal::Plane_curve> curves(const std::string& name) const
  {
    std::vector<std::string> notes;
    return conformal::read_plane_curves(path(name), {}, notes);
  }

  Curve points(const std::string& name) const { return curves(name).at(0).points; }
};

std::string rows(const Curve& curve)
{
  std::string text;
  for (const auto& p : curve.colwise()) {
    conformal::append_number(text, p.x());
    conformal::append_number(text += ',', p.y());
    text += '\n';
  }
  return text;
}

TEST_F(Curve_command, makes_a_circle_without_stretching)
{
  write("a.csv", rows(cgp_test::flower(100)));
  const Program_run r = run("curve a.csv -o b.csv --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NEAR(cgp_test::energy_times_length(points("b.csv")), 4 * cgp_test::pi * cgp_test::pi,
              1e-5);
  EXPECT_LT(cgp_test::distortion(cgp_test::flower(100), points("b.csv")), 1e-12);
  EXPECT_NE(r.out.find("the energy has settled"), std::string::npos) << r.out;
  const auto report = json("b.json");
  EXPECT_EQ(report["command"], "curve");
  EXPECT_TRUE(report["verified"]);
  EXPECT_EQ(report["input"]["points"][0], 100);
  EXPECT_EQ(report["result"]["turning_number"][0], 1);
  EXPECT_NEAR(report["result"]["energy_times_length"]["final"][0], 39.478418, 1e-5);
  EXPECT_LT(report["result"]["length_distortion"], 1e-12);
  EXPECT_EQ(report["result"]["steps"], report["steps"].size());
  EXPECT_EQ(report["steps"][0]["step"], 1);
  for (const char* stage : {"read", "flow", "write", "total"})
    EXPECT_TRUE(report["seconds"].at(stage).is_number()) << stage;
}

TEST_F(Curve_command, reads_and_writes_every_format)
{
  write("a.csv", rows(cgp_test::rose(60)));
  ASSERT_EQ(run("curve -q a.csv --steps 1 -o b.csv").code, 0);
  ASSERT_EQ(run("curve -q a.csv --steps 1 -o b.svg").code, 0);
  ASSERT_EQ(run("curve -q a.csv --steps 1 -o b.obj").code, 0);
  EXPECT_EQ(points("b.svg"), points("b.csv"));
  EXPECT_EQ(points("b.obj"), points("b.csv"));
  for (const char* from : {"b.svg", "b.obj"}) {
    EXPECT_TRUE(curves(from).at(0).is_closed);
    ASSERT_EQ(run(std::string("curve -q --pieces 0 --steps 1 -o c.csv ") + from).code, 0);
    EXPECT_EQ(points("c.csv").cols(), 60);
  }
}

TEST_F(Curve_command, flows_all_curves_of_a_file)
{
  write("a.csv", rows(cgp_test::flower(50)) + "\n" + rows(cgp_test::figure_eight(60)) + "\n" +
                     rows(cgp_test::flower(50).leftCols(20)));
  const Program_run r = run("curve a.csv --steps 3 --time-step 0.25 -o b.csv --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto result = json("b.json")["result"];
  EXPECT_EQ(result["turning_number"][0], 1);
  EXPECT_EQ(result["turning_number"][1], 0);
  EXPECT_EQ(json("b.json")["input"]["closed"][2], 0);
  EXPECT_NEAR(double(result["energy"]["final"][2]) / double(result["energy"]["initial"][2]),
              std::pow(.25, 3), 1e-9);
  const auto all = curves("b.csv");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].is_closed && all[1].is_closed && !all[2].is_closed);
  EXPECT_EQ(all[2].points.cols(), 20);
}

TEST_F(Curve_command, ends_are_detected_or_told)
{
  const auto closed = [&](const std::string& options) {
    EXPECT_EQ(run("curve -q a.csv --steps 1 -o b.svg --json b.json " + options).code, 0);
    return json("b.json")["input"]["closed"][0] == 1;
  };
  write("a.csv", rows(cgp_test::flower(50)));
  EXPECT_TRUE(closed(""));
  EXPECT_TRUE(closed("--ends closed"));
  EXPECT_FALSE(closed("--ends open"));
  write("a.csv", rows(cgp_test::flower(50).leftCols(30)));
  EXPECT_FALSE(closed(""));
  EXPECT_TRUE(closed("--ends closed"));
}

TEST_F(Curve_command, least_squares_stretches_a_little)
{
  write("a.csv", rows(cgp_test::flower(200)));
  ASSERT_EQ(
      run("curve -q a.csv --steps 1 --time-step 0.4 --advanced closing=least-squares -o b.csv")
          .code,
      0);
  EXPECT_NEAR(cgp_test::distortion(cgp_test::flower(200), points("b.csv")), 3.316e-3, 1e-5);
}

TEST_F(Curve_command, snapshots_are_the_curves_on_the_way)
{
  write("a.csv", rows(cgp_test::flower(50)));
  ASSERT_EQ(run("curve -q a.csv --steps 5 --time-step 0.1 --every 2 -o b.csv").code, 0);
  ASSERT_EQ(run("curve -q a.csv --steps 2 --time-step 0.1 -o c.csv").code, 0);
  EXPECT_EQ(content(path("b_0002.csv")), content(path("c.csv")));
  EXPECT_TRUE(has("b_0004.csv"));
  EXPECT_FALSE(has("b_0001.csv") || has("b_0005.csv"));
  EXPECT_EQ(temporary_files(), 0u);
}

TEST_F(Curve_command, a_snapshot_does_not_replace_the_input)
{
  write("a_0001.csv", rows(cgp_test::flower(50)));
  const std::string before = content(path("a_0001.csv"));
  const Program_run r = run("curve a_0001.csv --steps 2 --time-step 0.1 --every 1 -o a.csv");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.err.find("a_0001.csv is not written: it is the input"), std::string::npos) << r.err;
  EXPECT_EQ(content(path("a_0001.csv")), before);
  EXPECT_TRUE(has("a_0002.csv"));
}

TEST_F(Curve_command, animation_has_a_frame_for_each_step_and_ends_with_the_result)
{
  write("a.csv", rows(cgp_test::flower(50)));
  ASSERT_EQ(run("curve -q a.csv --steps 6 --time-step 0.1 --animate --seconds 2.5 -o b.svg").code,
            0);
  ASSERT_EQ(run("curve -q a.csv --steps 6 --time-step 0.1 -o c.svg").code, 0);
  const std::string text = content(path("b.svg"));
  EXPECT_NE(text.find("<animate attributeName=\"points\" dur=\"2.5s\""), std::string::npos);
  EXPECT_EQ(std::count(text.begin(), text.end(), ';'), 7);  // 7 curves, the last one twice
  EXPECT_EQ(points("b.svg"), points("c.svg"));
  ASSERT_EQ(run("curve -q a.csv --steps 6 --time-step 0.1 --animate --every 3 -o b.svg").code, 0);
  const std::string fewer = content(path("b.svg"));
  EXPECT_EQ(std::count(fewer.begin(), fewer.end(), ';'), 3);
  EXPECT_TRUE(fails(run("curve a.csv --animate -o b.csv"), 2, "--animate wants an output"));
}

TEST_F(Curve_command, bezier_curves_are_sampled)
{
  write("a.svg", "<svg><path d='M0,0 C0,1 1,1 1,0 C1,-1 0,-1 0,0 Z'/></svg>");
  ASSERT_EQ(run("curve -q a.svg --steps 1 --advanced samples=5 --pieces 0 -o b.csv").code, 0);
  EXPECT_EQ(points("b.csv").cols(), 10);
}

TEST_F(Curve_command, long_edges_are_divided_so_that_they_can_bend)
{
  write("a.svg", "<svg><polygon points='0,0 3,0 3,1 0,1'/></svg>");
  ASSERT_EQ(run("curve -q a.svg -o b.csv").code, 0);
  EXPECT_EQ(points("b.csv").cols(), 200);
  const auto radii = [](const Curve& c) {
    const Eigen::Vector2d mean = c.rowwise().mean();
    return Eigen::VectorXd((c.colwise() - mean).colwise().norm());
  };
  EXPECT_TRUE(radii(points("b.csv")).isApproxToConstant(8 / (2 * cgp_test::pi), 1e-3));
  write("a.csv", "0,0\n3,0\n3,1\n0,1\n");
  ASSERT_EQ(run("curve -q a.csv --ends open --pieces 7 --steps 1 -o b.csv").code, 0);
  EXPECT_EQ(points("b.csv").cols(), 8);
  ASSERT_EQ(run("curve -q a.csv --ends open --steps 1 -o b.csv").code, 0);
  EXPECT_EQ(points("b.csv").cols(), 4);
}

TEST_F(Curve_command, tells_the_point_that_is_unsuitable)
{
  write("line.csv", "0,0\n2,0\n1,0\n0,1\n");
  EXPECT_TRUE(fails(run("curve line.csv --steps 1 -o b.csv"), 4,
                    "line.csv: curve 0: 1 point where the curve goes straight back"));
  write("two.csv", "0,0\n2,0\n");
  EXPECT_TRUE(fails(run("curve two.csv --steps 1 -o b.csv"), 4, "2 points; a curve of three"));
  EXPECT_FALSE(has("b.csv"));
}

TEST_F(Curve_command, repeated_points_are_left_out_with_a_note)
{
  write("a.csv", "0,0\n1,0\n1,0\n1,1\n0,1\n0,0\n");
  const Program_run r = run("curve a.csv --steps 1 -o b.csv");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.err.find("note: left out: 1 point that repeats the one before"), std::string::npos)
      << r.err;
  EXPECT_EQ(points("b.csv").cols(), 4);
  EXPECT_TRUE(
      fails(run("curve a.csv --advanced strict --steps 1 -o c.csv"), 4, "left out: 1 point"));
  EXPECT_FALSE(has("c.csv"));
}

TEST_F(Curve_command, nonsense_is_refused)
{
  write("a.csv", rows(cgp_test::flower(50)));
  for (const std::string option :
       {"--steps 0", "--steps many", "--time-step 0", "--time-step 1", "--every 0",
        "--advanced samples=0", "--pieces -1", "--ends loose", "--advanced closing=never",
        "--seconds 3", "--seconds 0 --animate"})
    EXPECT_EQ(run("curve a.csv -o b.svg " + option).code, 2) << option;
  EXPECT_TRUE(fails(run("curve a.csv -o b.png"), 5, "b.png: has no known extension"));
  EXPECT_TRUE(fails(run("curve a.png -o b.svg"), 3, "a.png: has no known extension"));
  EXPECT_TRUE(fails(run("curve missing.csv -o b.svg"), 3, "missing.csv"));
  EXPECT_TRUE(fails(run("curve a.csv -o no/such/b.svg"), 5, "no/such/b.svg"));
}

TEST_F(Curve_command, interrupted_it_leaves_the_last_complete_step)
{
  write("a.csv", rows(cgp_test::flower(2000)));
  for (const auto& [signal, code] : {std::pair("INT", 130), std::pair("TERM", 143)}) {
    // The first snapshot shows that there is a complete step; thousands would follow.
    const Program_run r =
        shell("rm -f b*.csv b.json; " + program() +
              " curve -q a.csv --steps 99999 --time-step 1e-7 --every 1 -o b.csv --json b.json & "
              "for i in $(seq 3000); do [ -e b_0001.csv ] && break; sleep 0.01; done; kill -" +
              std::string(signal) + " $!; wait $!");
    EXPECT_TRUE(fails(r, code, "were written to b.csv")) << r.err;
    const int steps = json("b.json")["result"]["steps"];
    EXPECT_GE(steps, 1);
    EXPECT_LT(steps, 99999);
    EXPECT_EQ(json("b.json")["result"]["stop"][0], "interrupted");
    std::string number = std::to_string(steps);
    number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
    EXPECT_EQ(content(path("b.csv")), content(path("b_" + number + ".csv")));
    EXPECT_EQ(temporary_files(), 0u);
  }
}

TEST_F(Curve_command, help_has_an_example)
{
  const Program_run r = run("curve --help");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.out.find("Example: conformal curve"), std::string::npos);
}

}  // namespace cgp_test::curve_tests
