// Tests examples/conformal/commands/spin.cpp examples/conformal/commands/flow.cpp
// Tests examples/conformal/input/boundary_condition.cpp examples/conformal/report/verification.cpp
// Tests examples/conformal/report/certificate.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/bounded_support.h"

#include <cmath>

namespace cgp_test::bounded_surfaces_tests {

using namespace program_test;
using cgp_test::disk;
using cgp_test::pi;
using Bounded = Bounded_program;

const std::vector<std::string> conditions = {"free", "tangents", "binormals"};

/// in degrees, between vectors of unit length
double largest_angle(const Points& a, const Points& b)
{
  double angle = 0;
  for (Eigen::Index k = 0; k < a.cols(); ++k)
    angle = std::max(angle, std::acos(std::min(1., a.col(k).dot(b.col(k)))));
  return 180 / pi * angle;
}

/// a cap with bumps; where z is 0 the normals are horizontal
cgp_test::Mesh_view bumpy_cap(int n)
{
  return cgp_test::mapped(cgp_test::cap_from_disk(disk(n), pi / 3), [](const Eigen::Vector3d& p) {
    const double bumps = std::sin(5 * p.x()) * std::cos(4 * p.y());
    return Eigen::Vector3d((1 + 0.06 * (bumps + 0.5 * std::cos(6 * p.z() + p.x()))) * p);
  });
}

TEST_F(Bounded, spin_takes_all_three_conditions)
{
  const auto mesh = disk(12);
  write("a.off", off(mesh));
  for (const std::string& condition : conditions) {
    const Program_run r =
        run("spin a.off --rho-expression '2*gauss(sqrt(x^2+y^2),0.3)' --boundary " + condition +
            " -o b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << condition << r.err;
    const Points b = points("b.ply");
    const auto ring = outer_ring(12);
    double height = b(2, 0);
    for (const int v : ring) height -= b(2, v) / static_cast<double>(ring.size());
    EXPECT_GT(height, 0.05) << condition;  // positive rho bulges along the normals
    EXPECT_LT(json("b.json")["result"]["quasi_conformal"]["mean"], 1.05) << condition;
    EXPECT_EQ(json("b.json")["result"]["boundary"]["condition"].get<std::string>().find(condition),
              0u);
    const double angle = largest_angle(directions(mesh.positions(), ring), directions(b, ring));
    EXPECT_LT(angle, condition == "tangents" ? 1 : 30) << condition;
  }
}

TEST_F(Bounded, free_boundary_is_the_default)
{
  write("a.off", off(disk(8)));
  const std::string spin = "spin -q a.off --rho-expression x ";
  ASSERT_EQ(run(spin + "-o b.ply").code, 0);
  ASSERT_EQ(run(spin + "--boundary free -o c.ply").code, 0);
  EXPECT_EQ(content(path("b.ply")), content(path("c.ply")));
}

TEST_F(Bounded, solvers_agree)
{
  write("a.off", off(disk(8)));
  const std::string spin = "spin -q a.off --rho-expression 'x*y' --boundary binormals -o ";
  ASSERT_EQ(run(spin + "b.ply").code, 0);
  for (const std::string solver : {"cholmod", "eigen"}) {
    ASSERT_EQ(run(spin + "c.ply --advanced solver=" + solver).code, 0);
    EXPECT_LT((points("b.ply") - points("c.ply")).cwiseAbs().maxCoeff(), 1e-5) << solver;
  }
}

TEST_F(Bounded, holes_stay_closed)
{
  write("a.off", off(cgp_test::annulus(0.4, 1, 48, 8)));
  for (const std::string& condition : conditions) {
    const Program_run r = run("spin a.off --rho-expression 'sin(3*x+1)' --boundary " + condition +
                              " -o b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << condition << r.err;
    EXPECT_LT(json("b.json")["result"]["quasi_conformal"]["mean"], 1.1) << condition;
    EXPECT_EQ(json("b.json")["result"]["reached"], 1) << condition;
    EXPECT_LT(json("b.json")["result"]["period_defect"], 0.02) << condition;
  }
}

TEST_F(Bounded, flow_flattens_a_cap_unless_its_binormals_stay)
{
  const auto mesh = bumpy_cap(12);
  write("a.off", off(mesh));
  for (const std::string& condition : conditions) {
    const Program_run r =
        run("flow a.off --steps 6 --boundary " + condition + " -o b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << condition << r.err;
    const auto report = json("b.json");
    double energy = report["result"]["energy"]["initial"];
    EXPECT_GT(energy, 3.4);
    for (const auto& step : report["steps"]) {
      if (condition != "binormals") {
        EXPECT_LT(step["energy"], energy);
      }
      energy = step["energy"];
    }
    // A spherical cap of the angle pi/3 has the energy pi, and constant mean curvature.
    if (condition == "binormals") {
      EXPECT_NEAR(energy, pi, 0.3);
      const double first = report["steps"][0]["direction_norm"];
      EXPECT_LT(report["result"]["mean_curvature"]["not_closing"], .3 * first);
    } else {
      EXPECT_LT(energy, 0.1) << condition;
    }
    EXPECT_FALSE(report["result"].contains("radius"));
    const double angle = largest_angle(directions(mesh.positions(), outer_ring(12)),
                                       directions(points("b.ply"), outer_ring(12)));
    EXPECT_LT(angle, condition == "tangents" ? 2 : 90) << condition;
  }
}

TEST_F(Bounded, flow_refuses_to_balance_areas)
{
  write("a.off", off(disk(4)));
  EXPECT_TRUE(fails(run("flow a.off --balance initial -o b.ply"), 4, "wants a closed surface"));
}

TEST_F(Bounded, generalized_problem_is_for_closed_surfaces)
{
  write("a.off", off(disk(4)));
  EXPECT_TRUE(
      fails(run("spin a.off --rho-expression x --on faces --advanced problem=generalized -o b.ply"),
            4, "try: --advanced problem=standard"));
}

TEST_F(Bounded, a_single_triangle_is_no_accident)
{
  write("a.off", off(cgp_test::single_triangle()));
  for (const std::string& condition : conditions) {
    const Program_run r =
        run("spin a.off --rho-expression x --boundary " + condition + " -o b.ply");
    EXPECT_TRUE(r.code == 0 || fails(r, 1, "try:")) << r.code << r.err;
  }
}

}  // namespace cgp_test::bounded_surfaces_tests
