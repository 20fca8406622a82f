// Tests examples/conformal/commands/flow.cpp examples/conformal/transform/flow_report.cpp
// Tests examples/conformal/transform/Flow_watch.cpp examples/conformal/commands/flow.cpp
// Tests examples/conformal/report/Grid.cpp examples/conformal/transform/suitable_surface.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"
#include "support/thin_faces.h"
#include "support/tori.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace cgp_test::flow_tests {

using namespace program_test;
using conformal::read_surface;

class Flow : public Program {
 protected:
  nlohmann::json json(const std::string& name) const { return read_json(name); }
};

/// the standard deviation of the distances from the mean point by their mean, of even meshes
double unroundness(const conformal::Surface_file& file)
{
  const auto n = static_cast<Eigen::Index>(file.points.size());
  Eigen::Matrix3Xd p(3, n);
  for (Eigen::Index v = 0; v < n; ++v)
    for (Eigen::Index i = 0; i < 3; ++i)
      p(i, v) = file.points[static_cast<std::size_t>(v)][static_cast<std::size_t>(i)];
  const Eigen::Vector3d center = p.rowwise().mean();
  const Eigen::ArrayXd r = (p.colwise() - center).colwise().norm();
  return std::sqrt((r - r.mean()).square().mean()) / r.mean();
}

TEST_F(Flow, makes_a_bumpy_sphere_round_and_keeps_the_numbering)
{
  write("a.off", off(cgp_test::bumpy_sphere(3)));
  const Program_run r = run("flow a.off --steps 5 -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto a = read_surface(path("a.off")), b = read_surface(path("b.ply"));
  EXPECT_EQ(a.polygons.corners, b.polygons.corners);
  EXPECT_GT(unroundness(a), 0.02);
  EXPECT_LT(unroundness(b), 0.005);
  EXPECT_NE(find_property(b.vertices, "quality"), nullptr);
  EXPECT_LT(json("b.json")["result"]["radius"]["deviation"], 0.005);
  EXPECT_NE(r.out.find("radius, deviation / mean"), std::string::npos) << r.out;
}

TEST_F(Flow, takes_faces_of_area_zero_with_mollify_also_on_surfaces_with_handles)
{
  for (const cgp_test::Mesh_view& clean :
       {cgp_test::bumpy_sphere(2), cgp_test::torus(2, 1, 24, 12)}) {
    write("a.off", off(cgp_test::with_thin_faces(clean, 0)));
    EXPECT_TRUE(fails(run("flow a.off --steps 2 -o b.ply"), 4, "area zero"));
    const Program_run r = run("flow a.off --mollify --steps 2 -o b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_NE(r.out.find("edges flipped"), std::string::npos) << r.out;
    const auto report = json("b.json");
    EXPECT_TRUE(report["verified"]);
    EXPECT_GT(report["result"]["mollification"]["flipped_edges"], 100);
    EXPECT_LT(report["result"]["energy"]["final"], report["result"]["energy"]["initial"]);
    EXPECT_LT(report["result"]["period_defect"], .02);
    EXPECT_LT(report["result"]["quasi_conformal"]["mean"], 1.05);
    EXPECT_LT(report["result"]["triangulation"]["length_cross_ratio"]["max"], 1e-9);
  }
}

TEST_F(Flow, report_has_a_step_for_each_step_with_falling_energies)
{
  write("a.off", off(cgp_test::bumpy_sphere(3)));
  ASSERT_EQ(run("flow -q a.off --plain --steps 3 --time-step 0.5 -o b.ply --json b.json").code, 0);
  const auto report = json("b.json");
  EXPECT_EQ(report["command"], "flow");
  EXPECT_TRUE(report["verified"]);
  EXPECT_EQ(report["result"]["stop"], "all steps are done");
  ASSERT_EQ(report["steps"].size(), 3u);
  double energy = report["result"]["energy"]["initial"];
  for (const auto& step : report["steps"]) {
    EXPECT_LT(step["energy"], energy);
    energy = step["energy"];
    EXPECT_EQ(step["time_step"], 0.5);
    EXPECT_EQ(step["trials"], 1);
    EXPECT_EQ(step["period_defect"], 0);
    for (const char* place : {"gamma", "closure_residual", "quasi_conformal/step/mean",
                              "quasi_conformal/total/max", "seconds"})
      EXPECT_TRUE(step.at(nlohmann::json::json_pointer(std::string("/") + place)).is_number())
          << place;
  }
  EXPECT_EQ(report["result"]["energy"]["final"], energy);
  EXPECT_EQ(report["result"]["steps"], 3);
  for (const char* stage : {"read", "flow", "write", "total"})
    EXPECT_TRUE(report["seconds"].at(stage).is_number()) << stage;
}

TEST_F(Flow, makes_ten_steps_if_not_told_otherwise)
{
  write("a.off", off(cgp_test::bumpy_sphere(2)));
  ASSERT_EQ(run("flow -q a.off --time-step 0.1 -o b.ply --json b.json").code, 0);
  EXPECT_EQ(json("b.json")["result"]["steps"], 10);
  EXPECT_EQ(json("b.json")["result"]["stop"], "all steps are done");
}

TEST_F(Flow, says_once_that_it_takes_long)
{
  write("a.off", off(cgp_test::bumpy_sphere(1)));
  for (const int steps : {59, 70}) {
    const Program_run r =
        run("flow a.off --plain --time-step 0.01 --steps " + std::to_string(steps) + " -o b.ply");
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.err, steps < 60 ? ""
                                : "conformal: note: this takes long: 60 steps, where most surfaces "
                                  "settle in 5 to 20; a signal (Ctrl-C) ends it, and the surface "
                                  "so far is written\n");
  }
}

TEST_F(Flow, keeps_a_volume_or_leads_to_it)
{
  const auto long_sphere = cgp_test::mapped(cgp_test::icosphere(2), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), 1.8 * p.z());
  });
  write("a.off", off(long_sphere));
  ASSERT_EQ(run("flow a.off --steps 40 --reduced-volume keep -o b.ply --json b.json").code, 0);
  const auto kept = json("b.json")["result"]["reduced_volume"];
  EXPECT_NEAR(kept["final"], kept["initial"], 1e-9);
  EXPECT_LT(kept["final"], .95);
  const Program_run r = run("flow a.off --steps 40 --reduced-volume .85 -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.out.find("reduced volume"), std::string::npos) << r.out;
  const auto result = json("b.json")["result"];
  EXPECT_NEAR(result["reduced_volume"]["final"], .85, 1e-9);
  const double area = result["area"]["final"], volume = result["volume"]["final"];
  EXPECT_NEAR(6 * std::sqrt(std::acos(-1.)) * volume / std::pow(area, 1.5), .85, 1e-9);
  EXPECT_TRUE(fails(run("flow a.off --steps 1 --reduced-volume .5 -o b.ply"), 1, "not yet 0.5"));
}

TEST_F(Flow, takes_a_volume_that_a_closed_surface_has)
{
  write("a.off", off(cgp_test::icosphere(1)));
  write("disk.off", off(cgp_test::disk(2)));
  for (const char* volume : {"0", "-.5", "1.01", "small", "nan"})
    EXPECT_TRUE(fails(run(std::string("flow a.off -o b.ply --reduced-volume ") + volume), 2,
                      "above 0 and up to 1"));
  EXPECT_TRUE(fails(run("flow disk.off -o b.ply --reduced-volume .5"), 4, "closed"));
  EXPECT_TRUE(fails(run("flow a.off -o b.ply --plain --reduced-volume .5"), 2, "--plain"));
  EXPECT_TRUE(
      fails(run("flow a.off -o b.ply --balance initial --reduced-volume .5"), 2, "--balance"));
}

TEST_F(Flow, says_in_words_why_it_stops_early)
{
  write("round.off", off(cgp_test::icosphere(3)));
  const Program_run r = run("flow round.off --steps 50 -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const std::string stop = json("b.json")["result"]["stop"];
  EXPECT_TRUE(stop == "the energy has settled" || stop == "nothing is left of the direction")
      << stop;
  EXPECT_TRUE(json("b.json")["result"]["converged"]);
  EXPECT_NE(r.out.find("stopped because"), std::string::npos) << r.out;
  EXPECT_LT(unroundness(read_surface(path("b.ply"))), 1e-4);
}

TEST_F(Flow, keeps_handles_closed)
{
  write("a.off", off(cgp_test::storus(24)));
  ASSERT_EQ(run("flow -q a.off --steps 2 -o b.ply --json b.json").code, 0);
  const auto report = json("b.json");
  EXPECT_LT(report["result"]["energy"]["final"], report["result"]["energy"]["initial"]);
  EXPECT_LT(report["result"]["quasi_conformal"]["mean"], 1.05);
  EXPECT_GT(report["steps"][0]["period_defect"], 0);
  EXPECT_LT(report["steps"][0]["period_defect"], 0.02);
  double largest = 0;
  for (const auto& step : report["steps"])
    largest = (std::max)(largest, step["period_defect"].get<double>());
  EXPECT_EQ(report["result"]["period_defect"], largest);
  EXPECT_FALSE(report["result"].contains("radius"));
}

TEST_F(Flow, filter_keeps_large_features)
{
  write("a.off", off(cgp_test::bumpy_sphere(3)));
  ASSERT_EQ(run("flow -q a.off --steps 3 -o b.ply").code, 0);
  ASSERT_EQ(
      run("flow -q a.off --steps 3 --filter-weight 0.001 --advanced filter-order=2 -o c.ply").code,
      0);
  EXPECT_GT(unroundness(read_surface(path("c.ply"))), 3 * unroundness(read_surface(path("b.ply"))));
  EXPECT_TRUE(
      fails(run("flow a.off --steps 3 --advanced filter-order=2 -o d.ply"), 2, "--filter-weight"));
}

TEST_F(Flow, balance_brings_areas_back)
{
  cgp_test::Mesh_view bent = cgp_test::storus(24);  // straight, it is balanced by its symmetry
  cgp_test::Points positions = bent.positions();
  positions.row(1) += .2 * positions.row(0).cwiseAbs2();
  bent.set_positions(positions);
  write("a.off", off(bent));
  for (const std::string balance : {"none", "initial", "canonical"})
    EXPECT_EQ(run("flow -q a.off --steps 2 --balance " + balance + " -o " + balance + ".ply").code,
              0);
  const auto none = read_surface(path("none.ply")).points,
             canonical = read_surface(path("canonical.ply")).points;
  double most = 0;
  for (std::size_t v = 0; v < none.size(); ++v)
    most = (std::max)(most, std::abs(none[v][0] - canonical[v][0]));
  EXPECT_GT(most, 1e-3);
  write("sphere.off", off(cgp_test::bumpy_sphere(2)));
  EXPECT_EQ(run("flow -q sphere.off --steps 2 --balance initial -o b.ply").code, 0);
  EXPECT_TRUE(fails(run("flow sphere.off --steps 2 --balance canonical -o c.ply"), 4,
                    "no canonical metric; try: --balance initial"));
  EXPECT_FALSE(has("c.ply"));
}

TEST_F(Flow, snapshots_are_the_surfaces_on_the_way)
{
  write("a.off", off(cgp_test::bumpy_sphere(2)));
  ASSERT_EQ(run("flow -q a.off --plain --steps 5 --time-step 0.2 --every 2 -o b.ply").code, 0);
  ASSERT_EQ(run("flow -q a.off --plain --steps 2 --time-step 0.2 -o c.ply").code, 0);
  EXPECT_EQ(content(path("b_0002.ply")), content(path("c.ply")));
  EXPECT_TRUE(has("b_0004.ply"));
  for (const char* name : {"b_0000.ply", "b_0001.ply", "b_0003.ply", "b_0005.ply"})
    EXPECT_FALSE(has(name)) << name;
  EXPECT_EQ(temporary_files(), 0u);
}

TEST_F(Flow, snapshots_have_their_number_before_the_extension)
{
  write("a.off", off(cgp_test::bumpy_sphere(2)));
  ASSERT_EQ(run("flow -q a.off --steps 1 --every 1 -o .off").code, 0);
  EXPECT_TRUE(has("_0001.off"));
  ASSERT_EQ(
      shell("mkdir b.c && " + program() + " flow -q a.off --steps 1 --every 1 -o ./b.c/d.e.off")
          .code,
      0);
  EXPECT_TRUE(has("b.c/d.e_0001.off"));
}

TEST_F(Flow, a_snapshot_does_not_replace_the_input)
{
  write("a_0001.off", off(cgp_test::bumpy_sphere(2)));
  const std::string before = content(path("a_0001.off"));
  const Program_run r = run("flow a_0001.off --steps 2 --every 1 -o a.off");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.err.find("a_0001.off is not written: it is the input"), std::string::npos) << r.err;
  EXPECT_EQ(content(path("a_0001.off")), before);
  EXPECT_TRUE(has("a_0002.off"));
}

TEST_F(Flow, keeps_the_exact_conformal_class)
{
  write("a.off", off(cgp_test::irregular_torus(2, 1, 24, 12)));
  ASSERT_EQ(run("flow -q a.off --steps 3 -o b.ply --json b.json").code, 0);
  const auto exact = json("b.json");
  EXPECT_LT(exact["result"]["triangulation"]["length_cross_ratio"]["max"], 1e-10);
  EXPECT_LT(exact["result"]["conformal_type_change"], .01);
  EXPECT_TRUE(exact["steps"][0]["faired"]);
  ASSERT_EQ(run("flow -q a.off --steps 3 --advanced no-fairing -o b.ply --json b.json").code, 0);
  EXPECT_FALSE(json("b.json")["steps"][0]["faired"]);
  ASSERT_EQ(run("flow -q a.off --steps 3 --plain -o b.ply --json b.json").code, 0);
  EXPECT_GT(json("b.json")["result"]["length_cross_ratio"]["max"], 1e-3);
}

// On the faces of the files, as `compare` measures them.
TEST_F(Flow, tells_the_numbers_of_the_surface_as_written)
{
  write("a.off", off(cgp_test::irregular_torus(2, 1, 24, 12)));
  ASSERT_EQ(run("flow -q a.off --steps 3 -o b.off --json b.json").code, 0);
  ASSERT_EQ(run("compare -q a.off b.off --json c.json").code, 0);
  const auto flow = json("b.json")["result"], seen = json("c.json")["result"];
  for (const char* number : {"mean", "p99", "max"})
    EXPECT_NEAR(flow["quasi_conformal"][number], seen["quasi_conformal"][number], 1e-12);
  EXPECT_NE(flow["triangulation"]["quasi_conformal"]["max"], flow["quasi_conformal"]["max"]);
  EXPECT_NEAR(flow["energy"]["initial"], seen["willmore_energy"]["before"], 1e-9);
  EXPECT_NEAR(flow["energy"]["final"], seen["willmore_energy"]["after"], 1e-9);
  EXPECT_NEAR(json("b.json")["steps"].back()["energy"], flow["energy"]["final"], 1e-3);
}

// A cylinder of radius 1 with its binormals kept stays what it is: H = 1/2.
TEST_F(Flow, tells_how_constant_the_mean_curvature_is)
{
  write("a.off", off(cgp_test::cylinder(1, 2, 48, 16)));
  ASSERT_EQ(run("flow -q a.off --boundary binormals --steps 3 -o b.off --json b.json").code, 0);
  const auto H = json("b.json")["result"]["mean_curvature"];
  EXPECT_NEAR(std::abs(H["mean"].get<double>()), .5, .002);
  EXPECT_LT(H["deviation"], .002);
}

TEST_F(Flow, interrupted_it_leaves_the_last_complete_step)
{
  write("a.off", off(cgp_test::bumpy_sphere(4)));
  for (const auto& [signal, code] : {std::pair("INT", 130), std::pair("TERM", 143)}) {
    // The first snapshot shows that there is a complete step; thousands would follow.
    const Program_run r =
        shell("rm -f b*.ply b.json; " + program() +
              " flow -q a.off --steps 9999 --time-step 1e-5 --every 1 -o b.ply --json b.json & "
              "for i in $(seq 3000); do [ -e b_0001.ply ] && break; sleep 0.01; done; kill -" +
              std::string(signal) + " $!; wait $!");
    EXPECT_TRUE(fails(r, code, "steps were written to b.ply") ||
                fails(r, code, "was written to b.ply"))
        << r.err;
    const auto report = json("b.json");
    const int steps = report["result"]["steps"];
    EXPECT_GE(steps, 1);
    EXPECT_LT(steps, 9999);
    EXPECT_EQ(report["result"]["stop"], "interrupted");
    EXPECT_TRUE(report["verified"]);
    std::string number = std::to_string(steps);
    number.insert(0, 4 - number.size(), '0');
    EXPECT_EQ(content(path("b.ply")), content(path("b_" + number + ".ply")));
    EXPECT_EQ(temporary_files(), 0u);
  }
}

TEST_F(Flow, nonsense_is_refused)
{
  write("a.off", off(cgp_test::icosphere(1)));
  for (const std::string option :
       {"--steps 0", "--steps -3", "--steps 2 --time-step 0", "--time-step 2.1",
        "--steps 2 --filter-weight -1", "--steps 2 --every 0",
        "--steps 2 --filter-weight 1 --advanced filter-order=4", "--steps 2 --balance much",
        "--steps 2 --max-scale 1", "--steps many"})
    EXPECT_EQ(run("flow a.off -o b.ply " + option).code, 2) << option;
  EXPECT_TRUE(fails(run("flow a.off --steps 2 -o b.xyz"), 5, "b.xyz"));
}

TEST_F(Flow, help_tells_about_signals)
{
  const Program_run r = run("flow --help");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.out.find("130 or 143"), std::string::npos);
  EXPECT_NE(r.out.find("Example: conformal flow"), std::string::npos);
}

}  // namespace cgp_test::flow_tests
