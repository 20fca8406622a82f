// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests examples/conformal/commands/fair.cpp
#include "conformal/io/read_surface.h"
#include "conformal/io/write_surface.h"
#include "program/bounded_support.h"
#include "support/mesh_tools.h"
#include "support/several_components.h"
#include "support/spheres.h"

namespace cgp_test::fair_tests {

using namespace program_test;
using Fair = Bounded_program;

const double rim = .3;

/// a unit sphere with a dent above z = .45
cgp_test::Mesh_view dented_sphere()
{
  return cgp_test::mapped(cgp_test::geodesic_sphere(12), [](const Eigen::Vector3d& p) {
    const double d = (std::max)(0., p.z() - .45);
    return Eigen::Vector3d(p.x(), p.y(), p.z() - 2 * d * d);
  });
}

/// the formula that is positive above a height: in the frame of formulas, the middle of the
/// bounding box is 0 and its diagonal 2
std::string above(double height, const Points& p)
{
  const Eigen::Vector3d low = p.rowwise().minCoeff(), high = p.rowwise().maxCoeff();
  const double z = (height - (low.z() + high.z()) / 2) / ((high - low).norm() / 2);
  return "--region-expression 'z-(" + std::to_string(z) + ")' ";
}

double distance_from_unit_sphere(const Points& p)
{
  return (p.colwise().norm().array() - 1).abs().maxCoeff();
}

/// whether what is below the dent has not moved
::testing::AssertionResult keeps_the_rest(const Points& before, const Points& after)
{
  for (int v = 0; v < before.cols(); ++v)
    if (before(2, v) < rim && before.col(v) != after.col(v))
      return ::testing::AssertionFailure() << "vertex " << v << " has moved";
  return ::testing::AssertionSuccess();
}

TEST_F(Fair, takes_a_dent_out_of_a_sphere)
{
  write("a.off", off(dented_sphere()));
  const Points before = points("a.off");
  for (const std::string way : {"", "--outline"}) {
    const Program_run r = run("fair a.off " + above(rim, before) + way + " -o b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << r.err;
    const Points after = points("b.ply");
    EXPECT_LT(distance_from_unit_sphere(after), .1 * distance_from_unit_sphere(before)) << way;
    EXPECT_TRUE(keeps_the_rest(before, after)) << way;
    const auto report = json("b.json");
    EXPECT_TRUE(report["verified"]);
    EXPECT_LT(report["result"]["energy"]["after"], report["result"]["energy"]["before"]);
    EXPECT_LT(report["result"]["normal_jump"]["after"], 30);
    EXPECT_GT(report["result"]["free_vertices"], 100);
    const double largest = way.empty() ? 1e-9 : 10;
    EXPECT_LT(report["result"]["length_cross_ratio"]["max"], largest);
  }
}

TEST_F(Fair, takes_the_region_from_a_property)
{
  write("a.off", off(dented_sphere()));
  ASSERT_EQ(run("fair a.off " + above(rim, points("a.off")) + "-o b.ply").code, 0);
  auto file = conformal::read_surface(path("a.off"));
  std::vector<double> heights;
  for (const auto& p : file.points) heights.push_back(p[2] - rim);
  set_property(file.vertices, "inside", heights);
  write_surface(path("c.ply"), file);
  const Program_run r = run("fair c.ply --region-property inside -o d.ply");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_LT((points("b.ply") - points("d.ply")).cwiseAbs().maxCoeff(), 1e-6);
}

TEST_F(Fair, leaves_components_without_a_region_alone)
{
  const auto both = cgp_test::interleaved(
      {dented_sphere(), cgp_test::moved(cgp_test::geodesic_sphere(4), {0, 0, -9})});
  write("a.off", off(both.mesh));
  const Points before = points("a.off");
  const Program_run r = run("fair a.off --each-component " + above(rim, before) + "-o b.ply");
  ASSERT_EQ(r.code, 0) << r.err;
  const Points after = points("b.ply");
  for (const int v : both.vertices[1]) EXPECT_EQ(before.col(v), after.col(v));
  EXPECT_NE(before, after);
}

TEST_F(Fair, refuses_what_is_no_region)
{
  write("a.off", off(dented_sphere()));
  const auto is_refused = [&](const std::string& options, int code, const std::string& words) {
    EXPECT_TRUE(fails(run("fair a.off -o b.ply " + options), code, words)) << options;
    EXPECT_FALSE(has("b.ply"));
  };
  is_refused("", 2, "region");
  is_refused("--region-expression 1 --region-property x", 2, "region");
  is_refused("--region-expression 'z+'", 2, "--region-expression");
  is_refused("--region-expression 'z-99'", 4, "no vertex is in the region");
  is_refused("--region-expression 0/0", 4, "no vertex is in the region");
  is_refused("--region-expression 1", 4, "the whole component");
  is_refused("--region-property none", 4, "none");
  is_refused("--region-expression 'z-.4' --limit quasi_conformal=1", 1, "quasi-conformal");
}

}  // namespace cgp_test::fair_tests
