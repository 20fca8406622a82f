// Tests examples/conformal/commands/flatten.cpp examples/conformal/transform/flat_image.cpp
// Tests examples/conformal/transform/flat_distortion.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/bounded_support.h"
#include "support/spheres.h"

#include "conformal/io/data/texture_coordinates.h"

#include <cmath>

namespace cgp_test::flatten_tests {

using namespace program_test;
using cgp_test::cap_from_disk;
using cgp_test::disk;
using cgp_test::pi;

class Flatten : public Bounded_program {
 protected:
  /// texture coordinates as points with z = 0
  Points texture(const std::string& name) const
  {
    const auto file = conformal::read_surface(path(name));
    const auto values = conformal::vertex_values(file, conformal::texture_coordinates(file));
    Points p = Points::Zero(3, static_cast<Eigen::Index>(file.points.size()));
    if (values)
      for (Eigen::Index v = 0; v < p.cols(); ++v)
        p.col(v).head<2>() << (*values)[static_cast<std::size_t>(v)][0],
            (*values)[static_cast<std::size_t>(v)][1];
    return p;
  }
};

/// the deviation from a round disk, by the radii of the rings of `disk(n)`
double deviation_from_disk(const Points& p, int n)
{
  const Eigen::Vector3d centre = p.col(0);
  const double radius = (p.col(p.cols() - 1) - centre).norm();
  double worst = 0;
  for (Eigen::Index v = 1, k = 1; v < p.cols(); ++v) {
    if (v == 1 + 3 * k * (k + 1)) ++k;
    worst =
        std::max(worst, std::abs((p.col(v) - centre).norm() / radius - static_cast<double>(k) / n));
  }
  return worst;
}

TEST_F(Flatten, writes_the_stereographic_projection_of_a_cap_as_texture_coordinates)
{
  const auto cap = cap_from_disk(disk(12), 2.);
  write("a.off", off(cap));
  for (const std::string how : {"", "--method spectral ", "--method dirac "}) {
    const Program_run r = run("flatten a.off " + how + "-o b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << r.err;
    const Points uv = texture("b.ply");
    EXPECT_LT(deviation_from_disk(uv, 12), 0.01);
    EXPECT_NEAR(uv.minCoeff(), 0, 1e-6);
    EXPECT_NEAR(uv.maxCoeff(), 1, 1e-6);
    EXPECT_LT((points("b.ply") - cap.positions()).norm(), 1e-12);
    EXPECT_EQ(json("b.json")["result"]["flipped_faces"], 0);
    EXPECT_EQ(json("b.json")["verified"], true);
    EXPECT_NE(r.out.find("flipped faces"), std::string::npos);
  }
  EXPECT_EQ(json("b.json")["result"]["method"], "dirac");
}

TEST_F(Flatten, writes_the_flat_mesh)
{
  const auto cap = cap_from_disk(disk(8), 1.);
  write("a.off", off(cap));
  ASSERT_EQ(run("flatten a.off --planar-mesh -o b.ply").code, 0);
  const Points p = points("b.ply");
  EXPECT_EQ(p.row(2).cwiseAbs().maxCoeff(), 0);
  EXPECT_NEAR(cgp_test::area({p, cap.corners()}), cgp_test::area(cap), 1e-6);
}

TEST_F(Flatten, by_curvature_makes_a_hemisphere_a_round_disk)
{
  write("a.off", off(cap_from_disk(disk(12), pi / 2)));
  const Program_run r = run("flatten a.off --planar --planar-mesh -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_LT(deviation_from_disk(points("b.ply"), 12), 0.01);
  EXPECT_LT(json("b.json")["result"]["height"], 1e-2);
  EXPECT_EQ(json("b.json")["result"]["method"], "planar");
}

// On a coarse mesh the minimal surface is not quite plane.
TEST_F(Flatten, by_curvature_judges_the_plane_mesh_that_it_writes)
{
  write("a.off", off(cap_from_disk(cgp_test::jittered_disk(5, .6), 1.2)));
  ASSERT_EQ(run("flatten a.off --planar --planar-mesh --force -o b.ply --json b.json").code, 0);
  EXPECT_GT(json("b.json")["result"]["height"], 1e-4);
  EXPECT_EQ(points("b.ply").row(2).cwiseAbs().maxCoeff(), 0);
  ASSERT_EQ(run("compare a.off b.ply --json c.json").code, 0);
  const auto told = json("b.json")["result"], written = json("c.json")["result"];
  for (const char* what : {"quasi_conformal", "length_cross_ratio"})
    EXPECT_NEAR(told[what]["max"], written[what]["max"], 1e-9) << what;
}

// The image is round by symmetry, and by Riemann there is one.
TEST_F(Flatten, by_curvature_goes_as_many_steps_as_it_takes)
{
  write("a.off", off(cap_from_disk(disk(12), 2.4)));  // beyond the equator
  for (const char* limit : {"", " --limit closure=0.004"}) {
    const std::string flatten = "flatten a.off --planar --planar-mesh -o b.ply --json b.json";
    const Program_run r = run(flatten + limit);
    ASSERT_EQ(r.code, 0) << r.err;
    const auto result = json("b.json")["result"];
    EXPECT_LE(result["height"], .05);
    EXPECT_EQ(result["steps"] > 1, *limit != 0) << result["steps"];
    EXPECT_LT(deviation_from_disk(points("b.ply"), 12), 0.1) << limit;
  }
  write("a.off", off(cap_from_disk(disk(6), 3.1)));  // nearly closed, and too coarse
  EXPECT_TRUE(fails(run("flatten a.off --planar -o c.ply"), 1, "the mesh is too coarse"));
}

// The map shrinks a tube exponentially.
TEST_F(Flatten, counts_faces_that_shrink_to_nothing)
{
  write("a.off", off(cgp_test::cylinder(1, 80, 12, 100)));
  for (const std::string method : {"spectral", "dirac"}) {
    const std::string flatten =
        "flatten a.off -o " + method + ".ply --json b.json --method " + method;
    EXPECT_TRUE(fails(run(flatten), 1, "shrink to nothing"));
    EXPECT_FALSE(has(method + ".ply"));
    const Program_run r = run(flatten + " --force");
    EXPECT_EQ(r.out.find("inf"), std::string::npos) << r.out;
    EXPECT_GT(json("b.json")["result"]["collapsed_faces"], 10);
    EXPECT_TRUE(std::isfinite(json("b.json")["result"]["quasi_conformal"]["mean"].get<double>()));
    EXPECT_EQ(json("b.json")["verified"], false);
  }
}

TEST_F(Flatten, takes_holes)
{
  // Tapered: with both loops, a cylinder has two maps that are as good.
  write("a.off", off(cgp_test::ring(24, 6, [](double angle, double s) {
          const double r = 1 - s / 4;
          return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), s);
        })));
  ASSERT_EQ(run("flatten a.off -o b.obj --json b.json").code, 0);
  EXPECT_EQ(json("b.json")["result"]["boundary_loops"], 2);
  EXPECT_EQ(json("b.json")["result"]["normalized_vertices"], 24);
  ASSERT_EQ(run("flatten a.off --all-loops -o b.obj --json b.json").code, 0);
  EXPECT_EQ(json("b.json")["result"]["normalized_vertices"], 48);
  EXPECT_TRUE(fails(run("flatten a.off --planar -o c.obj"), 4, "not a disk"));
  EXPECT_FALSE(has("c.obj"));
}

TEST_F(Flatten, refuses_closed_surfaces_and_maps_that_do_not_verify)
{
  write("a.off", off(cgp_test::icosphere(1)));
  EXPECT_TRUE(fails(run("flatten a.off -o b.ply"), 4, "the surface is closed"));
  write("c.off", off(cap_from_disk(disk(8), 2.)));
  const std::string strict = "flatten c.off -o b.ply --limit quasi_conformal=1.001";
  EXPECT_TRUE(fails(run(strict), 1, "the mean quasi-conformal error is 1.1"));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_EQ(run(strict + " --force").code, 0);
  EXPECT_TRUE(has("b.ply"));
  EXPECT_TRUE(fails(run("flatten c.off --planar --method dirac -o b.ply"), 2, "excludes"));
}

TEST_F(Flatten, counts_flips_among_what_does_not_verify)
{
  const auto sphere = cgp_test::perturbed(cgp_test::icosphere(2), .15);
  write("a.off", off(cgp_test::without_face(sphere, 0)));
  EXPECT_TRUE(
      fails(run("flatten a.off -o b.ply --limit quasi_conformal=1e9 --limit flipped_share=0"), 1,
            "the share of flipped faces"));
}

}  // namespace cgp_test::flatten_tests
