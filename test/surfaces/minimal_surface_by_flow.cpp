// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/surfaces/minimal_surface.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

#include "spin/boundary_tools.h"
#include "support/random_delaunay.h"

namespace cgp_test::minimal_surface_by_flow_tests {

/// Minimal surfaces that one solve does not reach.

using Fault = CGP::Spin_report::Fault;

/// a disk with a tall bump, which is flat at its rim
Mesh_view bump()
{
  return mapped(random_domain(.08, 3), [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double s = 1 - p.squaredNorm();
    return {p.x(), p.y(), 2 * s * s};
  });
}

/// the transformation by a share of -H, with the tangents of the boundary
CGP::Spin_result part(const Mesh_view& mesh, double share)
{
  return CGP::Spin_transformation(mesh, {Boundary_condition::tangents()})
      .transform(Curvature_potential::on_vertices(-share * CGP::mean_curvature(mesh)));
}

TEST(Minimal_surface_that_is_far, is_refused_with_the_share_of_the_way_that_exists)
{
  const Mesh_view mesh = bump();
  const CGP::Spin_report r = CGP::spin_to_minimal_surface(mesh).report;
  EXPECT_EQ(r.fault(), Fault::boundary);
  EXPECT_GT(r.reached, .1);
  EXPECT_LT(r.reached, .9);
  EXPECT_TRUE(part(mesh, r.reached).report);
  EXPECT_FALSE(part(mesh, r.reached + 1. / 64).report);
}

TEST(Minimal_surface_that_is_far, is_found_after_the_flow_with_the_same_tangents)
{
  const Mesh_view mesh = bump();
  CGP::Flow_options options;
  options.surface.boundary = Boundary_condition::tangents();
  options.max_steps = 20;
  CGP::Conformal_willmore_flow flow(mesh, options);
  (void)flow.run();
  const CGP::Spin_result r = CGP::spin_to_minimal_surface(flow.mesh());
  EXPECT_TRUE(r.report);
  EXPECT_EQ(r.report.reached, 1);
  const Mesh_view found(r.positions, flow.mesh().corners());
  EXPECT_LT(CGP::willmore_energy(found), 1e-3 * CGP::willmore_energy(mesh));
  // The bump is round, and so is its minimal surface, with the tangents of the same circle.
  const auto rim = [](const Mesh_view& m) {
    return at_boundary(m, [](const Eigen::Vector3d& p, const auto&) { return p; });
  };
  EXPECT_LT(shape_error(rim(found), rim(mesh)), .01);
}

TEST(Minimal_surface_that_is_far, counts_the_turn_of_the_directions_as_part_of_the_way)
{
  // The tangents of a disk turn once, those of no plane curve are constant.
  const Mesh_view mesh = random_domain(.15, 4);
  const Points constant = at_boundary(mesh, [](const auto&, const auto&) -> Eigen::Vector3d {
    return {0, 0, 1};
  });
  const auto condition = Boundary_condition::tangents(constant);
  const CGP::Spin_report r = CGP::spin_to_minimal_surface(mesh, {condition}).report;
  EXPECT_EQ(r.fault(), Fault::boundary);
  EXPECT_GT(r.reached, 0);
  EXPECT_LT(r.reached, 1);
  const auto tilted = CGP::internal::part_of_turn(mesh, condition, .5);
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  for (std::size_t k = 0; k < b.frames.size(); ++k) {
    const Eigen::Vector3d halfway = (b.tangent(k) + constant.col(int(k))).normalized();
    EXPECT_LT((tilted.targets.col(int(k)) - halfway).norm(), 1e-12);
  }
}

}  // namespace cgp_test::minimal_surface_by_flow_tests
