// Tests examples/conformal/commands/flow.cpp examples/conformal/transform/flow_report.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace cgp_test::flow_stops_tests {

/// How flows end, and what they say then.

using namespace program_test;
using conformal::read_surface;

class Flow_that_stops : public Program {
 protected:
  nlohmann::json json(const std::string& name) const { return read_json(name); }
};

TEST_F(Flow_that_stops, what_does_not_verify_is_written_only_by_force)
{
  write("a.off", off(cgp_test::bumpy_sphere(2)));
  const std::string flow =
      "flow a.off --steps 2 --every 1 -o b.ply --json b.json --limit quasi_conformal=1.0001";
  EXPECT_TRUE(fails(run(flow), 1, "stopped after 0 of 2 steps: the limits of distortion"));
  EXPECT_FALSE(has("b.ply") || has("b_0001.ply") || has("b_0002.ply"));
  EXPECT_FALSE(json("b.json")["verified"]);
  EXPECT_EQ(run(flow + " --force").code, 0);
  EXPECT_TRUE(has("b.ply") && has("b_0001.ply") && has("b_0002.ply"));
}

/// the corners of a triangle of a file
std::array<Eigen::Vector3d, 3> triangle(const conformal::Surface_file& file, int f)
{
  std::array<Eigen::Vector3d, 3> p;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto v = file.polygons.corners[file.polygons.first[static_cast<std::size_t>(f)] + c];
    p[c] = Eigen::Vector3d(file.points[static_cast<std::size_t>(v)].data());
  }
  return p;
}

double area(const std::array<Eigen::Vector3d, 3>& p)
{
  return (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
}

/// in degrees
double least_angle(const std::array<Eigen::Vector3d, 3>& p)
{
  double least = 180;
  for (std::size_t c = 0; c < 3; ++c) {
    const Eigen::Vector3d a = p[(c + 1) % 3] - p[c], b = p[(c + 2) % 3] - p[c];
    least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / cgp_test::pi);
  }
  return least;
}

TEST_F(Flow_that_stops, stops_at_the_last_step_that_verifies_writes_it_and_fails)
{
  write("a.off", off(cgp_test::bumpy_sphere(3)));
  for (const std::string kind : {"", " --plain --time-step .25"}) {
    const Program_run r = run("flow a.off -o b.ply --json b.json --steps 10" + kind +
                              " --limit quasi_conformal=1.008");
    EXPECT_TRUE(fails(r, 1, "the limits of distortion are reached")) << r.err;
    EXPECT_TRUE(has("b.ply"));
    const auto report = json("b.json");
    EXPECT_FALSE(report["verified"]);
    EXPECT_LE(report["result"]["quasi_conformal"]["mean"], 1.008);
    EXPECT_GT(report["steps"].size(), 0u);
    EXPECT_LT(report["steps"].size(), 10u);
    const int vertex = report["result"]["stop_place"]["vertex"],
              face = report["result"]["stop_place"]["face"];
    EXPECT_NE(r.err.find(", most at vertex " + std::to_string(vertex) + ", where face " +
                         std::to_string(face)),
              std::string::npos)
        << r.err;
    const auto a = read_surface(path("a.off"));
    const auto first = a.polygons.corners.begin() + 3 * face;
    EXPECT_NE(std::find(first, first + 3, vertex), first + 3);
    EXPECT_NEAR(report["result"]["stop_place"]["angle_degrees"], least_angle(triangle(a, face)),
                1e-6);
    ASSERT_EQ(shell("rm b.ply").code, 0);
  }
}

TEST_F(Flow_that_stops, notes_how_much_has_become_small)
{
  const auto dumbbell = cgp_test::mapped(cgp_test::icosphere(4), [](const Eigen::Vector3d& p) {
    const double s = .15 + .85 * std::min(1., p.z() * p.z() / .36);
    return Eigen::Vector3d(s * p.x(), s * p.y(), 1.5 * p.z());
  });
  write("a.off", off(dumbbell));
  const Program_run r = run("flow a.off --steps 20 -o b.off");
  EXPECT_NE(r.err.find(" % of the area has shrunk below a tenth"), std::string::npos) << r.err;
  const std::string face_to = "lengths of face ";
  std::istringstream text(r.err.substr(r.err.find(face_to) + face_to.size()));
  int face = -1;
  std::string to;
  double scale = 0;
  text >> face >> to >> scale;
  const auto before = triangle(read_surface(path("a.off")), face),
             after = triangle(read_surface(path("b.off")), face);
  EXPECT_NEAR(std::sqrt(area(after) / area(before)) / scale, 1, .06) << r.err;
  const Program_run kept = run("flow a.off --steps 20 --max-scale 3 -o b.off --json b.json");
  EXPECT_EQ(kept.err.find("shrunk"), std::string::npos) << kept.err;
  const auto scales = json("b.json")["result"]["scale_control"];
  EXPECT_GE(scales["low"], .999 / 3);
  EXPECT_LE(scales["high"], 3.001);
  write("a.off", off(cgp_test::bumpy_sphere(3)));
  EXPECT_EQ(run("flow a.off --steps 3 -o b.off").err.find("shrunk"), std::string::npos);
}

TEST_F(Flow_that_stops, without_a_single_step_it_fails)
{
  write("a.off", off(cgp_test::bumpy_sphere(2)));
  EXPECT_TRUE(fails(run("flow -q a.off --plain --steps 2 --advanced tolerance=1e-30 -o b.ply"), 1,
                    "stopped after 0 of 2 steps"));
  EXPECT_FALSE(has("b.ply"));
}

}  // namespace cgp_test::flow_stops_tests
