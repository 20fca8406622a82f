// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Exact_steps.h
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include "spin/moebius_images.h"

namespace cgp_test::exact_steps_turned_tests {

const Eigen::Vector3d tangent(1, 0, 0), binormal(0, 0, 1), mixed(1, 0, 1);
const std::vector<Circle> one{{{.2, .1}, .3}}, two{{{.2, .1}, .3}, {{-.45, -.3}, .2}};

CGP::Spin_result closed(const Mesh_view& mesh, const Boundary_condition& condition,
                        const Curvature_potential& rho)
{
  return CGP::Spin_transformation(mesh, {condition}).transform(rho);
}

/// the binormals, or tangents, with those of each inner loop turned by an angle
Boundary_condition with_turned_holes(const Mesh_view& mesh, const Eigen::Vector3d& tnb,
                                     double angle)
{
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  Points V(3, 0);
  for (std::size_t l = 0, k = 0; l < b.loops.size(); ++l) {
    const bool is_outer = mesh.position(b.loops[l].front()).norm() > 1 - 1e-9;
    const Eigen::Vector3d axis = Eigen::Vector3d(1, .5 * double(l), 0).normalized();
    const Eigen::AngleAxisd turn(is_outer ? 0 : angle, axis);
    for (std::size_t i = 0; i < b.loops[l].size(); ++i, ++k) {
      V.conservativeResize(3, V.cols() + 1);
      V.rightCols(1) = turn * Eigen::Vector3d(b.frames[k] * tnb);
    }
  }
  return Boundary_condition::directions(tnb, V);
}

TEST(Exact_steps_to_new_directions, find_the_moebius_image_of_a_ring)
{
  for (const Eigen::Vector3d& tnb : {tangent, binormal, mixed})
    for (const auto& holes : {one, two}) {
      const std::vector<double> h{.2, .1, .05};
      std::vector<double> errors, defects;
      for (const double length : h) {
        const Moebius_image moebius(length, 11, holes);
        const CGP::Spin_result r = closed(moebius.source, moebius.directions(tnb), moebius.rho());
        EXPECT_TRUE(r.report) << tnb.transpose() << " " << length;
        EXPECT_LT(r.report.missing_share, .02);
        EXPECT_LT(r.report.added_share, .1 * length);
        errors.push_back(shape_error(r.positions, moebius.image.positions()));
        defects.push_back(r.report.closure_residual);
      }
      EXPECT_GT(slope(h, errors), .7) << tnb.transpose();
      EXPECT_LT(errors.back(), .004);
      EXPECT_GT(slope(h, defects), 1);
    }
}

TEST(Exact_steps_to_new_directions, add_the_rho_that_closes_rings_with_turned_loops)
{
  for (const auto& holes : {one, two})
    for (const double angle : {20., 60.}) {
      std::vector<double> added, closure;
      for (const double h : {.2, .1, .05}) {
        const Mesh_view ring = random_domain(h, 5, holes);
        const CGP::Spin_result r = closed(ring, with_turned_holes(ring, binormal, angle * pi / 180),
                                          CGP::no_potential(ring));
        EXPECT_TRUE(r.report) << angle << " " << h << to_string(r.report.fault());
        EXPECT_LE(r.report.period_defect, std::max(.25 * (mean_Q(r) - 1), .002) + 1e-12);
        EXPECT_EQ(r.report.missing_share, 0);
        added.push_back(r.report.added_share);
        closure.push_back(r.report.closure_residual);
      }
      EXPECT_GT(added.back(), .03);
      EXPECT_NEAR(added[1], added[2], .3 * added[2]);
      EXPECT_LT(closure.back(), closure.front());
    }
}

TEST(Exact_steps_to_new_directions, add_nothing_to_directions_that_a_surface_has)
{
  const Mesh_view ring = random_domain(.1, 5, one);
  for (const Eigen::Vector3d& tnb : {tangent, binormal}) {
    const auto condition = Boundary_condition::directions(tnb, quadratic_directions(ring, tnb));
    const CGP::Spin_result r = closed(ring, condition, CGP::no_potential(ring)),
                           once = transformed(ring, condition, CGP::no_potential(ring));
    EXPECT_TRUE(r.report);
    EXPECT_EQ(r.report.added_share, 0);
    EXPECT_LT((r.positions - once.positions).norm(), 1e-12);
  }
}

TEST(Exact_steps_to_new_directions, leave_out_of_a_strange_rho_what_does_not_close)
{
  const Mesh_view ring = random_domain(.1, 5, one);
  const auto rho = potential_on_vertices(
      ring, [](const Eigen::Vector3d& p) { return 2 * std::sin(3 * p.x() + 1) + p.y(); });
  const CGP::Spin_result r = closed(ring, with_turned_holes(ring, binormal, .3), rho);
  EXPECT_TRUE(r.report);
  EXPECT_EQ(r.report.steps, 1);
  EXPECT_GT(r.report.missing_share, .001);
  EXPECT_LT(r.report.missing_share, .5);
  EXPECT_NEAR(r.report.realised_share, 1 - r.report.missing_share, 1e-12);
  EXPECT_GT(r.report.added_share, .01);
}

}  // namespace cgp_test::exact_steps_turned_tests
