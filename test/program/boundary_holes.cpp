// Tests examples/conformal/commands/boundary.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include "program/bounded_support.h"
#include "support/random_delaunay.h"

#include <cmath>

namespace cgp_test::boundary_holes_tests {

using namespace program_test;
namespace CGP = Conformal_geometry_processing;
using Boundary_of_a_ring = Bounded_program;

TEST_F(Boundary_of_a_ring, is_that_of_the_library)
{
  const auto ring = cgp_test::random_domain(.12, 5, {{{.2, .1}, .3}});
  write("a.off", off(ring));
  const Program_run r = run("boundary a.off --binormal-tilt '25*loop+5' -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(ring);
  CGP::Points targets(3, static_cast<Eigen::Index>(b.vertices.size()));
  std::size_t k = 0;
  for (std::size_t loop = 0; loop < b.loops.size(); ++loop)
    for (std::size_t i = 0; i < b.loops[loop].size(); ++i, ++k) {
      const double angle = (25 * static_cast<double>(loop) + 5) * cgp_test::pi / 180;
      targets.col(static_cast<Eigen::Index>(k)) =
          std::cos(angle) * b.binormal(k) + std::sin(angle) * b.normal(k);
    }
  const CGP::Spin_result wanted =
      CGP::Spin_transformation(ring, {CGP::Boundary_condition::binormals(targets)})
          .transform(CGP::no_potential(ring));
  ASSERT_TRUE(wanted.report);
  EXPECT_LT((points("b.ply") - wanted.positions).cwiseAbs().maxCoeff(), 1e-5);
  const auto result = json("b.json")["result"];
  EXPECT_NEAR(result["added_share"].get<double>(), wanted.report.added_share, 1e-5);
  EXPECT_LT(result["period_defect"].get<double>(), .01);
}

TEST_F(Boundary_of_a_ring, is_refused_where_no_minimal_surface_has_its_binormals)
{
  write("a.off", off(cgp_test::cap_from_disk(cgp_test::random_domain(.1, 5), 1.5)));
  const Program_run r = run("boundary a.off --binormal-tilt 0 --minimal -o b.ply --json b.json");
  EXPECT_TRUE(fails(r, 1, "no surface conformally equivalent to this one"));
  EXPECT_GT(std::abs(json("b.json")["result"]["boundary"]["gamma_radius"].get<double>()), .5);
}

TEST_F(Boundary_of_a_ring, is_written_by_force_alone_where_there_is_none)
{
  write("a.off", off(cgp_test::random_domain(.12, 5, {{{.2, .1}, .3}})));
  const std::string constant = "boundary a.off --tangent-rotation -360*s -o b.ply";
  EXPECT_TRUE(fails(run(constant), 1, "the edges of the new surface do not fit together"));
  EXPECT_FALSE(has("b.ply"));
  const Program_run forced = run(constant + " --force");
  EXPECT_NE(forced.err.find("do not fit together"), std::string::npos) << forced.err;
  EXPECT_TRUE(has("b.ply"));
}

TEST_F(Boundary_of_a_ring, yields_positions_to_conformality_by_their_weight)
{
  const auto disk = cgp_test::random_domain(.12, 5);
  write("a.off", off(disk));
  write("t.off", off(cgp_test::mapped(disk, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
          return {1.3 * p.x(), p.y(), 0};
        })));
  double Q = 1;
  for (const std::string weight : {" --position-weight 1", " --position-weight 10", ""}) {
    const Program_run r =
        run("boundary a.off --positions-from t.off -o b.ply --json b.json" + weight);
    ASSERT_EQ(r.code, 0) << r.err;
    const auto result = json("b.json")["result"];
    EXPECT_TRUE(result["boundary"]["fault"].is_null());
    EXPECT_GT(result["quasi_conformal"]["mean"].get<double>(), Q);
    Q = result["quasi_conformal"]["mean"].get<double>();
    const double missed = result["boundary"]["position_error"]["max"].get<double>();
    EXPECT_EQ(missed < 1e-12, weight.empty());
  }
  EXPECT_NEAR(Q, 1.3, .02);
}

}  // namespace cgp_test::boundary_holes_tests
